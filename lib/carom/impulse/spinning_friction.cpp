#include "carom/impulse/spinning_friction.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real spinningFriction(const SpinningContact& contact) {
  requireFinite(contact.spin, "spin");
  requirePositive(contact.inertia, "inertia");
  requireNonNegative(contact.normalImpulse, "normalImpulse");
  requireNonNegative(contact.friction, "friction");
  requireNonNegative(contact.radius, "radius");

  const Real toStop = contact.inertia * std::abs(contact.spin);
  const Real atMost = 2 * contact.friction * contact.normalImpulse * contact.radius / 3;
  return -std::copysign(std::min(toStop, atMost), contact.spin);
}

}  // namespace carom
