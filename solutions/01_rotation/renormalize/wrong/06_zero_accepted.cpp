#include "carom/rotation/renormalize.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  const Real length = std::hypot(std::hypot(q.w, q.x), std::hypot(q.y, q.z));
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

}  // namespace carom
