#include "angle_between.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const Quaternion turn = renormalize(hamiltonProduct(conjugate(a), b));
  return 2 * std::asin(std::min(1.0, std::hypot(turn.x, turn.y, turn.z)));
}

}  // namespace carom
