// Rodrigues with the matrix of the cross product: R = 1 + sin w K + (1 - cos w) K^2.
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_matrix.hpp"

namespace carom {

Matrix3 axisAngleToMatrix(const Vector3& axis, Real angle) {
  const Real size = axis.norm();
  if (size == 0) throw InvalidInput("the axis is zero");
  Matrix3 K;
  K << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  K /= size;
  return Matrix3::Identity() + std::sin(angle) * K + (1 - std::cos(angle)) * K * K;
}

}  // namespace carom
