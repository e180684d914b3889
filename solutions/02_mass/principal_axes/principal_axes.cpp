// Exercise 02.principal_axes: the axes about which a body turns without wobbling.
// Check it with: ./course check 02.principal_axes

#include "carom/mass/principal_axes.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {
namespace {

// Given: turns the plane of the axes p and q so that A(p, q) becomes zero. A becomes Jᵀ A J and
// axes becomes axes J, so that axes A axesᵀ stays the same tensor.
[[maybe_unused]] void turnPlane(Matrix3& A, Matrix3& axes, int p, int q) {
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
  // Given: what is no tensor of inertia is refused.
  requireFinite(inertia, "inertia");
  const Real skew = (inertia - inertia.transpose()).cwiseAbs().maxCoeff();
  if (skew > 1e-12 * inertia.cwiseAbs().maxCoeff()) {
    reject("inertia", toText(inertia), "must be symmetric");
  }
  Matrix3 A = (inertia + inertia.transpose()) / 2;
  Matrix3 axes = Matrix3::Identity();
  //# solution

  // Each turn makes one entry zero and spoils the others a little. Ten sweeps are never used up.
  for (int sweep = 0; sweep < 10; ++sweep) {
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
  //# stub
  // Turn the three planes (0, 1), (0, 2), (1, 2) again and again until A is diagonal. Then put the
  // moments in ascending order, and their axes with them, so that the frame stays right-handed.
  //#| static_cast<void>(A);
  //#| static_cast<void>(axes);
  //#| return todo<PrincipalAxes>("principalAxes");
  //# end
}

}  // namespace carom
