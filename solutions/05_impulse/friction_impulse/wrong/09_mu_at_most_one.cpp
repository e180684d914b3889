// Exercise 05.friction_impulse: how much does friction take from the slip at a contact?
// Check it with: ./course check 05.friction_impulse

#include "carom/impulse/friction_impulse.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Vector3 frictionImpulse(const Vector3& relativeVelocity, const Vector3& normal, Real normalImpulse,
                        Real friction, Real tangentialMass) {
  // Given: what cannot be is refused.
  requireFinite(relativeVelocity, "relativeVelocity");
  requireFinite(normal, "normal");
  requireNonNegative(normalImpulse, "normalImpulse");
  requireNonNegative(friction, "friction");
  requirePositive(tangentialMass, "tangentialMass");
  const Vector3 slip = relativeVelocity - relativeVelocity.dot(normal) * normal;
  const Real speed = length(slip);
  if (speed == 0) return Vector3::Zero();

  const Real toStop = tangentialMass * speed;
  const Real atMost = std::min(friction, 1.0) * normalImpulse;
  return -std::min(toStop, atMost) / speed * slip;
}

}  // namespace carom
