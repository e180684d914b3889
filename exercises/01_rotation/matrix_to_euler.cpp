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

  // R(2, 0) is the entry in the last row and the first column. What do the last row and the first
  // column hold, and which of it vanishes at pitch = +-pi/2?
  return todo<EulerAngles>("matrixToEuler");
}

}  // namespace carom
