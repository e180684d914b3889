// Computes for ever.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  for (volatile int i = 0;; i = i + 1) {
  }
}

}  // namespace carom
