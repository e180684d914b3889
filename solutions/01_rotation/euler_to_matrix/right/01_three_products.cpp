// Each turn as a matrix of its own, and their product.
#include <cmath>

#include "carom/rotation/euler_to_matrix.hpp"

namespace carom {

Matrix3 eulerToMatrix(const EulerAngles& angles) {
  const Real a = angles.roll, b = angles.pitch, c = angles.yaw;
  Matrix3 Rx, Ry, Rz;
  Rx << 1, 0, 0, 0, std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a);
  Ry << std::cos(b), 0, std::sin(b), 0, 1, 0, -std::sin(b), 0, std::cos(b);
  Rz << std::cos(c), -std::sin(c), 0, std::sin(c), std::cos(c), 0, 0, 0, 1;
  return Rz * Ry * Rx;
}

}  // namespace carom
