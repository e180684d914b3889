#include <algorithm>
#include <cmath>

#include "carom/rotation/matrix_to_euler.hpp"

namespace carom {

EulerAngles matrixToEuler(const Matrix3& R) {
  const Real cosPitch = std::hypot(R(2, 1), R(2, 2));
  const Real pitch = std::atan2(-R(2, 0), cosPitch);
  if (cosPitch < 1e-8) return {0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  auto arcsine = [](Real s) { return std::asin(std::clamp(s, -1.0, 1.0)); };
  return {arcsine(R(2, 1) / cosPitch), pitch, arcsine(R(1, 0) / cosPitch)};
}

}  // namespace carom
