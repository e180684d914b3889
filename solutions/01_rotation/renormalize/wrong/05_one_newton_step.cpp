#include "carom/rotation/renormalize.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) throw InvalidInput("q is zero");
  const Real factor = (3 - (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z)) / 2;
  return {factor * q.w, factor * q.x, factor * q.y, factor * q.z};
}

}  // namespace carom
