#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"

namespace carom {

Quaternion axisAngleToQuaternion(const Vector3& axis, Real angle) {
  if (axis.isZero(0)) throw InvalidInput("the axis is zero");
  const Real half = angle / 2 * 3.14159265358979323846 / 180;
  const Vector3 v = std::sin(half) * axis.normalized();
  return {std::cos(half), v.x(), v.y(), v.z()};
}

}  // namespace carom
