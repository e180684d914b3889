#include "carom/mass/box_inertia.hpp"

#include <cmath>
#include <string>

#include "carom/core/errors.hpp"

namespace carom {

Matrix3 boxInertia(Real mass, const Vector3& size) {
  const bool positive = mass > 0 && size.x() > 0 && size.y() > 0 && size.z() > 0;
  if (!positive || !std::isfinite(mass) || !size.allFinite()) {
    throw InvalidInput("boxInertia: mass and edges must be positive and finite, but are " +
                       std::to_string(mass) + " and " + std::to_string(size.x()) + ", " +
                       std::to_string(size.y()) + ", " + std::to_string(size.z()));
  }
  const Real xx = size.x() * size.x();
  const Real yy = size.y() * size.y();
  const Real zz = size.z() * size.z();

  Matrix3 inertia = Matrix3::Zero();
  inertia(0, 0) = mass * (yy + zz) / 12;
  inertia(1, 1) = mass * (xx + zz) / 12;
  inertia(2, 2) = mass * (xx + yy) / 12;
  return inertia;
}

}  // namespace carom
