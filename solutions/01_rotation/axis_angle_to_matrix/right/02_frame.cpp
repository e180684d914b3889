// In a frame whose third axis is the axis of the turn it is a turn about z.
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_matrix.hpp"

namespace carom {

Matrix3 axisAngleToMatrix(const Vector3& axis, Real angle) {
  if (axis.isZero(0)) throw InvalidInput("the axis is zero");
  const Vector3 c = axis.normalized();
  int smallest = 0;
  c.cwiseAbs().minCoeff(&smallest);
  const Vector3 a = cross(c, Vector3::Unit(smallest)).normalized();
  const Vector3 b = cross(c, a);
  Matrix3 frame, turn;
  frame << a, b, c;
  turn << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  return frame * turn * frame.transpose();
}

}  // namespace carom
