#include "carom/mass/parallel_axis.hpp"

#include "carom/core/checks.hpp"

namespace carom {

Matrix3 parallelAxis(const Matrix3& inertiaAboutCenter, Real mass, const Vector3& offset) {
  requireFinite(inertiaAboutCenter, "inertiaAboutCenter");
  requireFinite(mass, "mass");
  requireFinite(offset, "offset");
  const Vector3& d = offset;
  Matrix3 result = inertiaAboutCenter;
  result.diagonal() += mass * (Vector3::Constant(d.dot(d)) - d.cwiseProduct(d));
  return result;
}

}  // namespace carom
