// The turn in the world, with the sign that makes it short.
#include "angle_between.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {

Real angleBetween(const Quaternion& a, const Quaternion& b) {
  Quaternion turn = hamiltonProduct(b, conjugate(a));
  if (turn.w < 0) turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  return 2 * std::atan2(std::hypot(turn.x, turn.y, turn.z), turn.w);
}

}  // namespace carom
