// Exercise 01.euler_to_matrix: the matrix of roll, pitch and yaw.
// Check it with: ./course check 01.euler_to_matrix

#include "carom/rotation/euler_to_matrix.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Matrix3 eulerToMatrix(const EulerAngles& angles) {
  requireFinite(angles.roll, "roll");
  requireFinite(angles.pitch, "pitch");
  requireFinite(angles.yaw, "yaw");

  // Multiply Rz(yaw) Ry(pitch) Rx(roll) out, fill R row by row (R << ...;) and return it.
  return todo<Matrix3>("eulerToMatrix");
}

}  // namespace carom
