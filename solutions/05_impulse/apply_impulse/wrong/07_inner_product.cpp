// Exercise 05.apply_impulse: what does an impulse do to the two bodies it acts between?
// Check it with: ./course check 05.apply_impulse

#include "carom/impulse/apply_impulse.hpp"

#include "carom/core/checks.hpp"

namespace carom {

void applyImpulse(OrientedBody& a, const Vector3& armA, OrientedBody& b, const Vector3& armB,
                  const Vector3& impulse) {
  // Given: what is no number is refused, before anything has changed.
  requireFinite(armA, "armA");
  requireFinite(armB, "armB");
  requireFinite(impulse, "impulse");
  a.velocity.linear -= a.inverseMass * impulse;
  b.velocity.linear += b.inverseMass * impulse;

  // Into the body's axes, divided by the inertia there, and back.
  const Vector3 torqueA = a.R_WB.transpose() * (armA.dot(impulse) * impulse.normalized());
  const Vector3 torqueB = b.R_WB.transpose() * (armB.dot(impulse) * impulse.normalized());
  a.velocity.angular -= a.R_WB * (a.inverseInertia * torqueA);
  b.velocity.angular += b.R_WB * (b.inverseInertia * torqueB);
}

}  // namespace carom
