#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"

namespace carom {

Quaternion axisAngleToQuaternion(const Vector3& axis, Real angle) {
  const Vector3 v = std::sin(angle / 2) * axis.normalized();
  return {std::cos(angle / 2), v.x(), v.y(), v.z()};
}

}  // namespace carom
