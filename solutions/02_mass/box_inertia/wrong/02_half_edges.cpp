#include "carom/mass/box_inertia.hpp"

#include "carom/core/checks.hpp"

namespace carom {

Matrix3 boxInertia(Real mass, const Vector3& size) {
  requirePositive(mass, "mass");
  for (int k = 0; k < 3; ++k) requirePositive(size[k], "size");
  const Real xx = size.x() / 2 * size.x() / 2;
  const Real yy = size.y() / 2 * size.y() / 2;
  const Real zz = size.z() / 2 * size.z() / 2;

  Matrix3 inertia = Matrix3::Zero();
  inertia(0, 0) = mass * (yy + zz) / 12;
  inertia(1, 1) = mass * (xx + zz) / 12;
  inertia(2, 2) = mass * (xx + yy) / 12;
  return inertia;
}

}  // namespace carom
