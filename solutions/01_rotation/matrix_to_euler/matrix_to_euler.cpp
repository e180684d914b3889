// Exercise 01.matrix_to_euler: roll, pitch and yaw of a rotation matrix.
// Check it with: ./course check 01.matrix_to_euler

#include "carom/rotation/matrix_to_euler.hpp"

#include <cmath>

#include "carom/core/elementary.hpp"
#include "carom/core/todo.hpp"
#include "carom/rotation/require_rotation.hpp"

namespace carom {

EulerAngles matrixToEuler(const Matrix3& R) {
  requireRotation(R, "R");

  //# solution
  // The last row of R is (-sin pitch, cos pitch sin roll, cos pitch cos roll).
  const Real cosPitch = std::sqrt(R(2, 1) * R(2, 1) + R(2, 2) * R(2, 2));
  EulerAngles angles;
  angles.pitch = arctangent2(-R(2, 0), cosPitch);
  angles.roll = cosPitch > 0 ? arctangent2(R(2, 1), R(2, 2)) : 0;

  // The second column of R Rx(-roll) is (-sin yaw, cos yaw, 0): it does not shrink near the lock.
  const Real s = sine(angles.roll), c = cosine(angles.roll);
  angles.yaw = arctangent2(s * R(0, 2) - c * R(0, 1), c * R(1, 1) - s * R(1, 2));
  return angles;
  //# stub
  // R(2, 0) is the entry in the last row and the first column. What do the last row and the first
  // column hold, and which of it vanishes at pitch = +-pi/2?
  //#| return todo<EulerAngles>("matrixToEuler");
  //# end
}

}  // namespace carom
