#include "carom/rotation/quaternion_logarithm.hpp"

#include <cmath>

#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Vector3 quaternionLogarithm(const Quaternion& q) {
  const Quaternion s = scaledQuaternion(q, "q");
  Vector3 v(s.x, s.y, s.z);
  if (s.w < 0) v = -v;  // -q is the same rotation, by the shorter way
  const Real size = length(v);
  if (size == 0) return Vector3::Zero();
  return 2 * arctangent2(size, std::abs(s.w)) / size * v;
}

}  // namespace carom
