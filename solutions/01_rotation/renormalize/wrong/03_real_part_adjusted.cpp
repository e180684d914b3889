#include "carom/rotation/renormalize.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) throw InvalidInput("q is zero");
  const Real w = std::sqrt(std::max(0.0, 1 - q.x * q.x - q.y * q.y - q.z * q.z));
  return {std::copysign(w, q.w), q.x, q.y, q.z};
}

}  // namespace carom
