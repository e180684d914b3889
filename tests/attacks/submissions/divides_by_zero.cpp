// Divides an integer by zero.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  volatile int seven = 7;
  volatile int zero = 0;
  return {static_cast<double>(seven / zero), 0, 0, 0};
}

}  // namespace carom
