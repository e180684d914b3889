#include <algorithm>
#include <cmath>

#include "carom/rotation/matrix_to_euler.hpp"

namespace carom {

EulerAngles matrixToEuler(const Matrix3& R) {
  return {std::atan2(R(2, 1), R(2, 2)), std::atan2(-R(2, 0), std::hypot(R(2, 1), R(2, 2))),
          std::atan2(R(1, 0), R(0, 0))};
}

}  // namespace carom
