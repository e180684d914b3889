// Exercise 01.quaternion_exponential: the quaternion of a rotation vector.
// Check it with: ./course check 01.quaternion_exponential

#include "carom/rotation/quaternion_exponential.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Quaternion quaternionExponential(const Vector3& rotationVector) {
  requireFinite(rotationVector, "rotationVector");
  const Real angle = length(rotationVector);
  requireFinite(angle, "|rotationVector|");

  //# solution
  // Below this angle [rad] the next term of the series, angle^4/3840, is below a rounding error.
  constexpr Real kSmall = 0x1p-11;
  const Real factor = angle < kSmall ? 0.5 - angle * angle / 48 : sine(angle / 2) / angle;
  const Vector3 v = factor * rotationVector;
  return {cosine(angle / 2), v.x(), v.y(), v.z()};
  //# stub
  // What becomes of sin(angle/2) / angle when the angle is zero?
  //#| static_cast<void>(angle);
  //#| return todo<Quaternion>("quaternionExponential");
  //# end
}

}  // namespace carom
