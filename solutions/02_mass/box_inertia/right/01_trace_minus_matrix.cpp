// Second moments on a diagonal, then trace minus matrix.
#include "carom/mass/box_inertia.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Matrix3 boxInertia(Real mass, const Vector3& size) {
  if (!(mass > 0) || !(size.minCoeff() > 0) || !size.allFinite() || mass > 1e300) {
    throw InvalidInput("a box has a positive mass and positive edges");
  }
  Matrix3 C = Matrix3::Zero();
  C.diagonal() = mass / 12 * size.cwiseProduct(size);
  return C.trace() * Matrix3::Identity() - C;
}

}  // namespace carom
