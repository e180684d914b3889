// Throws something that is no exception.
#include "carom/rotation/hamilton_product.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  throw 42;
}

}  // namespace carom
