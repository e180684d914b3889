#include "carom/mass/box_inertia.hpp"

#include "carom/core/checks.hpp"

namespace carom {

Matrix3 boxInertia(Real mass, const Vector3& size) {
  requirePositive(mass, "mass");
  for (int k = 0; k < 3; ++k) requirePositive(size[k], "size");
  const Real xx = size.x() * size.x();
  const Real yy = size.y() * size.y();
  const Real zz = size.z() * size.z();

  Matrix3 inertia = Matrix3::Zero();
  inertia(0, 0) = mass * (yy + zz) / 12;
  inertia(1, 1) = mass * (xx + zz) / 12;
  inertia(2, 2) = mass * (xx + yy) / 12;
  inertia(0, 1) = inertia(1, 0) = -mass * size.x() * size.y() / 12;
  inertia(0, 2) = inertia(2, 0) = -mass * size.x() * size.z() / 12;
  inertia(1, 2) = inertia(2, 1) = -mass * size.y() * size.z() / 12;
  return inertia;
}

}  // namespace carom
