#include "carom/mass/principal_axes.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "carom/core/errors.hpp"

namespace carom {
namespace {

// Turns the plane of axes p and q so that A(p, q) becomes zero: A <- Jᵀ A J, axes <- axes J.
void turnPlane(Matrix3& A, Matrix3& axes, int p, int q) {
  const Real off = A(p, q);
  // An entry that is mere rounding of its neighbours is none: turning would not improve the
  // moments, and a tensor that is the same in all directions would be turned by chance.
  const Real rounding = std::numeric_limits<Real>::epsilon() * std::sqrt(std::abs(A(p, p))) *
                        std::sqrt(std::abs(A(q, q)));
  if (std::abs(off) <= rounding) {
    A(p, q) = A(q, p) = 0;
    return;
  }
  // tan of the angle, the smaller of the two solutions of t² + 2 θ t - 1 = 0.
  const Real theta = (A(q, q) - A(p, p)) / (2 * off);
  const Real t = std::copysign(1 / (std::abs(theta) + std::hypot(theta, Real(1))), theta);
  const Real c = 1 / std::sqrt(1 + t * t);
  const Real s = t * c;
  // The diagonal is corrected rather than recomputed: that keeps the trace to the last digit.
  A(p, p) -= t * off;
  A(q, q) += t * off;
  A(p, q) = A(q, p) = 0;
  const int r = 3 - p - q;
  const Real rp = A(r, p);
  const Real rq = A(r, q);
  A(r, p) = A(p, r) = c * rp - s * rq;
  A(r, q) = A(q, r) = s * rp + c * rq;
  const Vector3 axisP = axes.col(p);
  const Vector3 axisQ = axes.col(q);
  axes.col(p) = c * axisP - s * axisQ;
  axes.col(q) = s * axisP + c * axisQ;
}

}  // namespace

PrincipalAxes principalAxes(const Matrix3& inertia) {
  const Real largest = inertia.cwiseAbs().maxCoeff();
  // Rounding leaves a few units in the last place between the halves; more is not a tensor of
  // inertia.
  constexpr Real kRounding = 1e-12;
  if (!inertia.allFinite() ||
      !((inertia - inertia.transpose()).cwiseAbs().maxCoeff() <= kRounding * largest)) {
    throw InvalidInput("principalAxes: the tensor must be finite and symmetric");
  }

  // Sweeps converge quadratically: five are enough for any 3x3 matrix, ten are never used up.
  Matrix3 A = (inertia + inertia.transpose()) / 2;
  Matrix3 axes = Matrix3::Identity();
  constexpr int kSweeps = 10;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    turnPlane(A, axes, 0, 1);
    turnPlane(A, axes, 0, 2);
    turnPlane(A, axes, 1, 2);
  }

  // Ascending moments; a swap of two axes mirrors the frame, so one of them is reversed with it.
  PrincipalAxes result{A.diagonal(), axes};
  const auto order = [&result](int i, int j) {
    if (result.moments[i] <= result.moments[j]) return;
    std::swap(result.moments[i], result.moments[j]);
    const Vector3 old = result.axes.col(i);
    result.axes.col(i) = result.axes.col(j);
    result.axes.col(j) = -old;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return result;
}

}  // namespace carom
