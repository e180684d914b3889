// Eigen's norm that takes care of the squares.
#include "carom/rotation/renormalize.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  const Vector4 v(q.w, q.x, q.y, q.z);
  const Real length = v.stableNorm();
  if (length == 0) throw InvalidInput("q is zero");
  return {v(0) / length, v(1) / length, v(2) / length, v(3) / length};
}

}  // namespace carom
