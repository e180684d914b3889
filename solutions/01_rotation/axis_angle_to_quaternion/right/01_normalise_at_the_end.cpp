// The four numbers are made |axis| times too long and brought to length 1 together.
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"

namespace carom {

Quaternion axisAngleToQuaternion(const Vector3& axis, Real angle) {
  const Real size = std::hypot(axis.x(), axis.y(), axis.z());
  if (size == 0) throw InvalidInput("the axis is zero");
  const Real w = size * std::cos(angle / 2), s = std::sin(angle / 2);
  const Vector4 q = Vector4(w, s * axis.x(), s * axis.y(), s * axis.z()).normalized();
  return {q(0), q(1), q(2), q(3)};
}

}  // namespace carom
