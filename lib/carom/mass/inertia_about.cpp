#include "carom/mass/inertia_about.hpp"

#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Real momentAboutAxis(const Matrix3& inertia, const Vector3& axis) {
  // Scaled by the largest entry first, so that the squares neither overflow nor vanish.
  const Real largest = axis.cwiseAbs().maxCoeff();
  if (!(largest > 0) || !axis.allFinite()) {
    throw InvalidInput("momentAboutAxis: the axis must be finite and not zero");
  }
  const Vector3 n = axis / largest;
  return n.dot(inertia * n) / n.dot(n);
}

Matrix3 rotateInertia(const Matrix3& inertia, const Matrix3& R_WB) {
  const Matrix3 turned = R_WB * inertia * R_WB.transpose();
  return (turned + turned.transpose()) / 2;  // the two triangles differ by rounding only
}

}  // namespace carom
