#include "carom/mass/parallel_axis.hpp"

#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Matrix3 parallelAxis(const Matrix3& inertiaAboutCenter, Real mass, const Vector3& offset) {
  if (!inertiaAboutCenter.allFinite() || !std::isfinite(mass) || !offset.allFinite()) {
    throw InvalidInput("parallelAxis: inertia, mass and offset must be finite numbers");
  }
  const Vector3& d = offset;
  return inertiaAboutCenter + mass * (d.dot(d) * Matrix3::Identity() - d * d.transpose());
}

}  // namespace carom
