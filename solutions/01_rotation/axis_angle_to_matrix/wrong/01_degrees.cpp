#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_matrix.hpp"

namespace carom {

Matrix3 axisAngleToMatrix(const Vector3& axis, Real angle) {
  if (axis.isZero(0)) throw InvalidInput("the axis is zero");
  const Vector3 a = axis.normalized();
  const Real s = std::sin(angle * 3.14159265358979323846 / 180),
             c = std::cos(angle * 3.14159265358979323846 / 180);
  Matrix3 R;
  for (int i = 0; i < 3; ++i) {
    const Vector3 e = Vector3::Unit(i);
    R.col(i) = c * e + s * cross(a, e) + (1 - c) * a.dot(e) * a;
  }
  return R;
}

}  // namespace carom
