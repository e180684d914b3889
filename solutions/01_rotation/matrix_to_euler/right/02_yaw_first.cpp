// Yaw is found first and undone; then pitch and roll are read from Ry Rx.
#include <cmath>

#include "carom/rotation/matrix_to_euler.hpp"

namespace carom {

EulerAngles matrixToEuler(const Matrix3& R) {
  const bool locked = R(2, 1) == 0 && R(2, 2) == 0;
  const Real yaw = locked ? std::atan2(-R(0, 1), R(1, 1)) : std::atan2(R(1, 0), R(0, 0));
  const Real c = std::cos(yaw), s = std::sin(yaw);
  // Rows of Rz(-yaw) R = Ry Rx, whose middle row is (0, cos roll, -sin roll).
  const Real cosRoll = c * R(1, 1) - s * R(0, 1);
  const Real minusSinRoll = c * R(1, 2) - s * R(0, 2);
  const Real pitch = std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2)));
  return {locked ? 0 : std::atan2(-minusSinRoll, cosRoll), pitch, yaw};
}

}  // namespace carom
