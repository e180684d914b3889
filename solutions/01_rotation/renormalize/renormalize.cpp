// Exercise 01.renormalize: the quaternion of length 1 in the direction of q.
// Check it with: ./course check 01.renormalize

#include "carom/rotation/renormalize.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  //# solution
  const Real largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  if (!(largest > 0) || !std::isfinite(largest)) {
    throw InvalidInput("q must be finite and not zero: it is no rotation");
  }
  const Vector4 v(q.w / largest, q.x / largest, q.y / largest, q.z / largest);
  if (!v.allFinite()) throw InvalidInput("q must be finite");
  const Real length = std::sqrt(v(0) * v(0) + v(1) * v(1) + v(2) * v(2) + v(3) * v(3));
  return {v(0) / length, v(1) / length, v(2) / length, v(3) / length};
  //# stub
  // Refuse the zero quaternion (throw InvalidInput("...")), and divide all four numbers by the
  // length. Mind the squares of very large and very small numbers.
  //#| return todo<Quaternion>("renormalize");
  //# end
}

}  // namespace carom
