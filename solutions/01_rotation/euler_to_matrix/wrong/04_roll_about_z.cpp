#include <cmath>

#include "carom/rotation/euler_to_matrix.hpp"

namespace carom {

Matrix3 eulerToMatrix(const EulerAngles& angles) {
  const Real sx = std::sin(angles.yaw), cx = std::cos(angles.yaw);
  const Real sy = std::sin(angles.pitch), cy = std::cos(angles.pitch);
  const Real sz = std::sin(angles.roll), cz = std::cos(angles.roll);
  Matrix3 R;
  R << cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx,  //
      sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx,   //
      -sy, cy * sx, cy * cx;
  return R;
}

}  // namespace carom
