// Ignores every signal that can be ignored, and computes for ever.
#include "carom/rotation/hamilton_product.hpp"

#include <csignal>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  for (int i = 1; i < 64; ++i) std::signal(i, SIG_IGN);
  for (volatile int i = 0;; i = i + 1) {
  }
}

}  // namespace carom
