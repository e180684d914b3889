// Turns the tensors instead of the torques.
#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/impulse/apply_impulse.hpp"

namespace carom {

namespace {

Velocity gained(const OrientedBody& body, const Vector3& arm, const Vector3& impulse) {
  const Matrix3 inverseInertia_W = body.R_WB * body.inverseInertia * body.R_WB.transpose();
  return {body.inverseMass * impulse, inverseInertia_W * cross(arm, impulse)};
}

}  // namespace

void applyImpulse(OrientedBody& a, const Vector3& armA, OrientedBody& b, const Vector3& armB,
                  const Vector3& impulse) {
  requireFinite(armA, "armA");
  requireFinite(armB, "armB");
  requireFinite(impulse, "impulse");
  const Velocity toA = gained(a, armA, -impulse), toB = gained(b, armB, impulse);
  a.velocity.linear += toA.linear;
  a.velocity.angular += toA.angular;
  b.velocity.linear += toB.linear;
  b.velocity.angular += toB.angular;
}

}  // namespace carom
