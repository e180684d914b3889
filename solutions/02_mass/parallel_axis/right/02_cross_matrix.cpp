// Minus the square of the matrix of the cross product with d.
#include "carom/mass/parallel_axis.hpp"

#include "carom/core/checks.hpp"

namespace carom {

Matrix3 parallelAxis(const Matrix3& inertiaAboutCenter, Real mass, const Vector3& offset) {
  requireFinite(inertiaAboutCenter, "inertia");
  requireFinite(mass, "mass");
  requireFinite(offset, "offset");
  Matrix3 crossWith;
  crossWith << 0, -offset.z(), offset.y(),  //
      offset.z(), 0, -offset.x(),           //
      -offset.y(), offset.x(), 0;
  return inertiaAboutCenter - mass * crossWith * crossWith;
}

}  // namespace carom
