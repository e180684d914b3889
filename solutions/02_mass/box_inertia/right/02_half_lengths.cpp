// With half lengths the factor is one third.
#include "carom/mass/box_inertia.hpp"

#include "carom/core/checks.hpp"

namespace carom {

Matrix3 boxInertia(Real mass, const Vector3& size) {
  requirePositive(mass, "mass");
  requirePositive(size.minCoeff(), "smallest edge");
  requirePositive(size.maxCoeff(), "largest edge");
  const Vector3 h = size / 2;
  Matrix3 inertia = Matrix3::Zero();
  for (int k = 0; k < 3; ++k) {
    const Real u = h[(k + 1) % 3];
    const Real v = h[(k + 2) % 3];
    inertia(k, k) = mass / 3 * (u * u + v * v);
  }
  return inertia;
}

}  // namespace carom
