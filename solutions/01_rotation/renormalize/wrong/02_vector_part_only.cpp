#include "carom/rotation/renormalize.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  const Real largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  if (largest == 0) throw InvalidInput("q is zero");
  const Real w = q.w / largest, x = q.x / largest, y = q.y / largest, z = q.z / largest;
  const Real length = std::sqrt(x * x + y * y + z * z);
  return {w / length, x / length, y / length, z / length};
}

}  // namespace carom
