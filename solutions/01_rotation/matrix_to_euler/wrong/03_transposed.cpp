#include <algorithm>
#include <cmath>

#include "carom/rotation/matrix_to_euler.hpp"

namespace carom {

EulerAngles matrixToEuler(const Matrix3& R) {
  const Real cosPitch = std::hypot(R(1, 2), R(2, 2));
  const Real pitch = std::atan2(-R(0, 2), cosPitch);
  if (cosPitch < 1e-8) return {0, pitch, std::atan2(-R(1, 0), R(1, 1))};
  return {std::atan2(R(1, 2), R(2, 2)), pitch, std::atan2(R(0, 1), R(0, 0))};
}

}  // namespace carom
