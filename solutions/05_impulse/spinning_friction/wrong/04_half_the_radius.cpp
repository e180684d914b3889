// Exercise 05.spinning_friction: why does a top stop that spins on one spot?
// Check it with: ./course check 05.spinning_friction

#include "carom/impulse/spinning_friction.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real spinningFriction(const SpinningContact& contact) {
  // Given: what cannot be is refused.
  requireFinite(contact.spin, "spin");
  requirePositive(contact.inertia, "inertia");
  requireNonNegative(contact.normalImpulse, "normalImpulse");
  requireNonNegative(contact.friction, "friction");
  requireNonNegative(contact.radius, "radius");
  const Real toStop = contact.inertia * std::abs(contact.spin);
  const Real atMost = 0.5 * contact.friction * contact.normalImpulse * contact.radius;
  return -std::copysign(std::min(toStop, atMost), contact.spin);
}

}  // namespace carom
