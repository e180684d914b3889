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

  //# solution
  const Real sx = sine(angles.roll), cx = cosine(angles.roll);
  const Real sy = sine(angles.pitch), cy = cosine(angles.pitch);
  const Real sz = sine(angles.yaw), cz = cosine(angles.yaw);
  Matrix3 R;
  // clang-format off
  R << cz * cy,  cz * sy * sx - sz * cx,  cz * sy * cx + sz * sx,
       sz * cy,  sz * sy * sx + cz * cx,  sz * sy * cx - cz * sx,
      -sy,       cy * sx,                 cy * cx;
  // clang-format on
  return R;
  //# stub
  // Multiply Rz(yaw) Ry(pitch) Rx(roll) out, fill R row by row (R << ...;) and return it.
  //#| return todo<Matrix3>("eulerToMatrix");
  //# end
}

}  // namespace carom
