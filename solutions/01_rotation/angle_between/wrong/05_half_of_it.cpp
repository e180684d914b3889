#include "angle_between.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const Quaternion turn = hamiltonProduct(conjugate(a), b);
  return std::atan2(std::hypot(turn.x, turn.y, turn.z), std::abs(turn.w));
}

}  // namespace carom
