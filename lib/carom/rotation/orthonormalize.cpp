#include "carom/rotation/orthonormalize.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"

namespace carom {
namespace {

// A matrix with entries up to 1 and a smaller determinant is far from any multiple of a rotation,
// for which it is at least 0.06, and the rotation nearest to it would be a matter of rounding
// errors.
constexpr Real kFlat = 1e-3;
constexpr int kMaxSteps = 60;  // the error halves at first, then squares: beyond any need

}  // namespace

Matrix3 orthonormalize(const Matrix3& M) {
  requireFinite(M, "M");
  const Real size = M.cwiseAbs().maxCoeff();
  if (size == 0) reject("M", toText(M), "must not be zero");
  int e = 0;
  std::frexp(size, &e);
  Matrix3 X = M.unaryExpr([e](Real entry) { return std::ldexp(entry, -e); });

  for (int step = 0; step < kMaxSteps; ++step) {
    const Vector3 x = X.col(0), y = X.col(1), z = X.col(2);
    Matrix3 cofactors;
    cofactors << cross(y, z), cross(z, x), cross(x, y);
    const Real determinant = cofactors.col(0).dot(x);
    if (step == 0 && !(determinant > kFlat)) {
      reject("M", toText(M), "must have a positive determinant, well away from 0");
    }
    const Matrix3 next = (X + cofactors / determinant) / 2;
    const Real change = (next - X).cwiseAbs().maxCoeff();
    X = next;
    if (change < 1e-9) break;  // quadratic: the change after this one is below 1e-17
  }
  return X;
}

}  // namespace carom
