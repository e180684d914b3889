// Refuses every question.
#include "carom/rotation/hamilton_product.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  throw InvalidInput("no");
}

}  // namespace carom
