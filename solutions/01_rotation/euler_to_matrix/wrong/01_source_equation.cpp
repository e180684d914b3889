#include <cmath>

#include "carom/rotation/euler_to_matrix.hpp"

namespace carom {

Matrix3 eulerToMatrix(const EulerAngles& angles) {
  const Real sx = std::sin(angles.roll), cx = std::cos(angles.roll);
  const Real sy = std::sin(angles.pitch), cy = std::cos(angles.pitch);
  const Real sz = std::sin(angles.yaw), cz = std::cos(angles.yaw);
  Matrix3 R;
  R << cz * sy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx,  //
      sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx,   //
      -sy, cy * sx, cy * cx;
  return R;
}

}  // namespace carom
