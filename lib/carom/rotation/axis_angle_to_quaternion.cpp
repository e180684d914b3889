#include "carom/rotation/axis_angle_to_quaternion.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/rotation/unit_axis.hpp"

namespace carom {

Quaternion axisAngleToQuaternion(const Vector3& axis, Real angle) {
  requireFinite(angle, "angle");
  const Vector3 a = unitAxis(axis, "axis");
  const Real s = sine(angle / 2);
  return {cosine(angle / 2), s * a.x(), s * a.y(), s * a.z()};
}

}  // namespace carom
