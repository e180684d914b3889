// The columns are where the axes go: turn each of them three times in its plane.
#include <cmath>
#include <utility>

#include "carom/rotation/euler_to_matrix.hpp"

namespace carom {

Matrix3 eulerToMatrix(const EulerAngles& angles) {
  auto turn = [](Real& u, Real& v, Real angle) {
    const Real before = u;
    u = std::cos(angle) * before - std::sin(angle) * v;
    v = std::sin(angle) * before + std::cos(angle) * v;
  };
  Matrix3 R = Matrix3::Identity();
  for (int column = 0; column < 3; ++column) {
    turn(R(1, column), R(2, column), angles.roll);
    turn(R(2, column), R(0, column), angles.pitch);
    turn(R(0, column), R(1, column), angles.yaw);
  }
  return R;
}

}  // namespace carom
