// Writes where nothing is.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  *reinterpret_cast<volatile int*>(8) = 1;
  return {0, 0, 0, 0};
}

}  // namespace carom
