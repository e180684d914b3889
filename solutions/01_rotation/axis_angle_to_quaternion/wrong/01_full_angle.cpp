#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"

namespace carom {

Quaternion axisAngleToQuaternion(const Vector3& axis, Real angle) {
  if (axis.isZero(0)) throw InvalidInput("the axis is zero");
  const Vector3 v = std::sin(angle) * axis.normalized();
  return {std::cos(angle), v.x(), v.y(), v.z()};
}

}  // namespace carom
