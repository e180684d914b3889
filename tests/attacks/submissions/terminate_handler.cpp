// Throws through what may not throw, with a handler that never ends.
#include "carom/rotation/hamilton_product.hpp"

#include <exception>
#include <stdexcept>
static void fail() noexcept {
  throw std::runtime_error("no");
}

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  std::set_terminate([] {
    for (volatile int i = 0;; i = 1) static_cast<void>(i);
  });
  fail();
  return {0, 0, 0, 0};
}

}  // namespace carom
