// Leaves the processor rounding upwards.
#include "carom/rotation/hamilton_product.hpp"

#include <cfenv>

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  std::fesetround(FE_UPWARD);
  return {0, 0, 0, 0};
}

}  // namespace carom
