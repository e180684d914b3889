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

  // What becomes of sin(angle/2) / angle when the angle is zero?
  static_cast<void>(angle);
  return todo<Quaternion>("quaternionExponential");
}

}  // namespace carom
