// Eigen's solver, and the frame made right-handed at the end.
#include <Eigen/Eigenvalues>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/mass/principal_axes.hpp"

namespace carom {

PrincipalAxes principalAxes(const Matrix3& inertia) {
  requireFinite(inertia, "inertia");
  const Matrix3 half = (inertia - inertia.transpose()) / 2;
  if (half.cwiseAbs().maxCoeff() > 1e-12 * inertia.cwiseAbs().maxCoeff()) {
    throw InvalidInput("principalAxes: the tensor must be symmetric");
  }
  const Matrix3 symmetric = (inertia + inertia.transpose()) / 2;
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(symmetric);
  PrincipalAxes result{solver.eigenvalues(), solver.eigenvectors()};
  result.axes.col(2) = cross(result.axes.col(0), result.axes.col(1));
  return result;
}

}  // namespace carom
