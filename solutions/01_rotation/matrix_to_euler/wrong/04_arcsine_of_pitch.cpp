#include <algorithm>
#include <cmath>

#include "carom/rotation/matrix_to_euler.hpp"

namespace carom {

EulerAngles matrixToEuler(const Matrix3& R) {
  const Real pitch = std::asin(std::clamp(-R(2, 0), -1.0, 1.0));
  if (std::hypot(R(2, 1), R(2, 2)) < 1e-8) return {0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

}  // namespace carom
