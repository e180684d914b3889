// Calls the library by the name that it defines itself.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  return carom::hamiltonProduct(q, r);
}

}  // namespace carom
