#include "carom/rotation/require_rotation.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"

namespace carom {

void requireRotation(const Matrix3& R, const char* name) {
  requireFinite(R, name);
  const Real error = (R.transpose() * R - Matrix3::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kRotationTolerance)) {
    reject(name, toText(R),
           "must be a rotation: R^T R differs from the unit matrix by " + toText(error));
  }
  const Vector3 x = R.col(0), y = R.col(1), z = R.col(2);
  if (cross(x, y).dot(z) < 0) reject(name, toText(R), "must be a rotation: it mirrors");
}

}  // namespace carom
