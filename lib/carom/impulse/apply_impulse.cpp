#include "carom/impulse/apply_impulse.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"

namespace carom {

namespace {

void push(OrientedBody& body, const Vector3& arm, const Vector3& impulse) {
  const Vector3 torque_B = body.R_WB.transpose() * cross(arm, impulse);  // into the body's axes
  const Vector3 change_B = body.inverseInertia * torque_B;
  body.velocity.linear += body.inverseMass * impulse;
  body.velocity.angular += body.R_WB * change_B;  // and back
}

}  // namespace

void applyImpulse(OrientedBody& a, const Vector3& armA, OrientedBody& b, const Vector3& armB,
                  const Vector3& impulse) {
  requireFinite(armA, "armA");
  requireFinite(armB, "armB");
  requireFinite(impulse, "impulse");
  push(a, armA, -impulse);
  push(b, armB, impulse);
}

}  // namespace carom
