#include "carom/rotation/axis_angle_to_matrix.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/rotation/unit_axis.hpp"

namespace carom {

Matrix3 axisAngleToMatrix(const Vector3& axis, Real angle) {
  requireFinite(angle, "angle");
  const Vector3 a = unitAxis(axis, "axis");

  const Real s = sine(angle);
  const Real c = cosine(angle);
  const Real halfSine = sine(angle / 2);
  const Vector3 b = 2 * halfSine * halfSine * a;  // (1 - cos w) a

  Matrix3 R;
  // clang-format off
  R << c + b.x() * a.x(),            b.x() * a.y() - s * a.z(),  b.x() * a.z() + s * a.y(),
           b.y() * a.x() + s * a.z(), c + b.y() * a.y(),         b.y() * a.z() - s * a.x(),
           b.z() * a.x() - s * a.y(),    b.z() * a.y() + s * a.x(), c + b.z() * a.z();
  // clang-format on
  return R;
}

}  // namespace carom
