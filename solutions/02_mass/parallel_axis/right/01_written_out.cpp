// Six different entries, one by one.
#include "carom/mass/parallel_axis.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Matrix3 parallelAxis(const Matrix3& inertiaAboutCenter, Real mass, const Vector3& offset) {
  const Real x = offset.x(), y = offset.y(), z = offset.z();
  Matrix3 point;
  point << y * y + z * z, -x * y, -x * z,  //
      -y * x, x * x + z * z, -y * z,       //
      -z * x, -z * y, x * x + y * y;
  const Matrix3 result = inertiaAboutCenter + mass * point;
  if (!result.allFinite()) throw InvalidInput("parallelAxis needs finite numbers");
  return result;
}

}  // namespace carom
