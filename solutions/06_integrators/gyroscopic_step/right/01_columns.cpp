// The slope column by column: what f changes by when one component of the velocity does.
#include <Eigen/LU>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/motion/gyroscopic_step.hpp"

namespace carom {

Vector3 gyroscopicStep(const Matrix3& inertia, const Vector3& angularVelocity, Real dt) {
  const Vector3& w = angularVelocity;
  if (!inertia.allFinite() || !w.allFinite() || !(dt - dt == 0)) throw InvalidInput("no number");
  Matrix3 slope;
  for (int i = 0; i < 3; ++i) {
    const Vector3 unit = Vector3::Unit(i), moved = inertia.col(i);
    slope.col(i) = moved + dt * (cross(unit, inertia * w) + cross(w, moved));
  }
  const Eigen::FullPivLU<Matrix3> solver(slope);
  if (!solver.isInvertible()) throw InvalidInput("the equations have no solution");
  return w - solver.solve(dt * cross(w, inertia * w));
}

}  // namespace carom
