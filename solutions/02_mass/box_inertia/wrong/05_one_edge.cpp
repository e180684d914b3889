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
  inertia(0, 0) = mass * zz / 12;
  inertia(1, 1) = mass * xx / 12;
  inertia(2, 2) = mass * yy / 12;
  return inertia;
}

}  // namespace carom
