#include "carom/mass/principal_axes.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "carom/core/checks.hpp"

namespace carom {
namespace {

void turnPlane(Matrix3& A, Matrix3& axes, int p, int q) {
  const Real off = A(p, q);
  const Real rounding =
      std::numeric_limits<Real>::epsilon() * std::sqrt(std::abs(A(p, p)) * std::abs(A(q, q)));
  if (std::abs(off) <= rounding) {
    A(p, q) = A(q, p) = 0;
    return;
  }
  const Real theta = (A(q, q) - A(p, p)) / (2 * off);
  const Real t = std::copysign(1 / (std::abs(theta) + std::hypot(theta, Real(1))), theta);
  const Real c = 1 / std::sqrt(1 + t * t);
  Matrix3 J = Matrix3::Identity();
  J(p, p) = J(q, q) = c;
  J(p, q) = t * c;
  J(q, p) = -t * c;
  A = (J.transpose() * A * J).eval();
  A(p, q) = A(q, p) = 0;
  axes = (axes * J).eval();
}

}  // namespace

PrincipalAxes principalAxes(const Matrix3& inertia) {
  requireFinite(inertia, "inertia");
  const Real skew = (inertia - inertia.transpose()).cwiseAbs().maxCoeff();
  if (skew > 1e-12 * inertia.cwiseAbs().maxCoeff()) {
    reject("inertia", toText(inertia), "must be symmetric");
  }
  Matrix3 A = (inertia + inertia.transpose()) / 2;
  Matrix3 axes = Matrix3::Identity();

  for (int sweep = 0; sweep < 1; ++sweep) {
    turnPlane(A, axes, 0, 1);
    turnPlane(A, axes, 0, 2);
    turnPlane(A, axes, 1, 2);
  }

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
