// Exercise 01.axis_angle_to_quaternion: the quaternion of an axis and an angle.
// Check it with: ./course check 01.axis_angle_to_quaternion

#include "carom/rotation/axis_angle_to_quaternion.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Quaternion axisAngleToQuaternion(const Vector3& axis, Real angle) {
  requireFinite(axis, "axis");
  requireFinite(angle, "angle");

  //# solution
  if (length(axis) == 0) throw InvalidInput("axis must not be zero: it has no direction");
  const Vector3 v = sine(angle / 2) / length(axis) * axis;
  return {cosine(angle / 2), v.x(), v.y(), v.z()};
  //# stub
  // Refuse the zero axis (throw InvalidInput("...")), bring the others to length 1, and put half of
  // the angle into the four numbers.
  //#| return todo<Quaternion>("axisAngleToQuaternion");
  //# end
}

}  // namespace carom
