// The usual way: below a threshold it is the lock, roll is 0, and yaw carries the rest.
#include <cmath>

#include "carom/rotation/matrix_to_euler.hpp"

namespace carom {

EulerAngles matrixToEuler(const Matrix3& R) {
  const Real cosPitch = std::hypot(R(2, 1), R(2, 2));
  const Real pitch = std::atan2(-R(2, 0), cosPitch);
  if (cosPitch < 1e-8) return {0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

}  // namespace carom
