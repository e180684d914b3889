// Exercise 06.gyroscopic_step: how does a step keep a body from spinning up out of nothing?
// Check it with: ./course check 06.gyroscopic_step

#include "carom/motion/gyroscopic_step.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"

namespace carom {
namespace {

// Given: the matrix [v]x with [v]x u = v x u.
[[maybe_unused]] Matrix3 crossMatrix(const Vector3& v) {
  Matrix3 m;
  m << 0, -v.z(), v.y(),  //
      v.z(), 0, -v.x(),   //
      -v.y(), v.x(), 0;
  return m;
}

// Given: the x with m x = b, by Cramer's rule.
[[maybe_unused]] Vector3 solve(const Matrix3& m, const Vector3& b) {
  const Vector3 x = m.col(0), y = m.col(1), z = m.col(2);
  const Real determinant = x.dot(cross(y, z));
  if (determinant == 0) reject("inertia", toText(m), "must leave the equations solvable");
  return Vector3(b.dot(cross(y, z)), x.dot(cross(b, z)), x.dot(cross(y, b))) / determinant;
}

}  // namespace

Vector3 gyroscopicStep(const Matrix3& inertia, const Vector3& angularVelocity, Real dt) {
  requireFinite(inertia, "inertia");
  requireFinite(angularVelocity, "angularVelocity");
  requireFinite(dt, "dt");
  const Vector3 momentum = inertia * angularVelocity;
  const Vector3 rest = dt * cross(angularVelocity, momentum);
  const Matrix3 slope =
      inertia + dt * (crossMatrix(angularVelocity) * inertia + crossMatrix(momentum));
  return angularVelocity - solve(slope, rest);
}

}  // namespace carom
