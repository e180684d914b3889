// Includes a file that has no end.
#include "carom/rotation/hamilton_product.hpp"

#include "/dev/zero"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
