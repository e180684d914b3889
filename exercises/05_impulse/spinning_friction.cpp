// Exercise 05.spinning_friction: why does a top stop that spins on one spot?
// Check it with: ./course check 05.spinning_friction

#include "carom/impulse/spinning_friction.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Real spinningFriction(const SpinningContact& contact) {
  // Given: what cannot be is refused.
  requireFinite(contact.spin, "spin");
  requirePositive(contact.inertia, "inertia");
  requireNonNegative(contact.normalImpulse, "normalImpulse");
  requireNonNegative(contact.friction, "friction");
  requireNonNegative(contact.radius, "radius");
  // std::min(a, b) is the smaller of two numbers, std::abs(x) the size of one, and
  // std::copysign(size, x) that size with the sign of x.
  return todo<Real>("spinningFriction");
}

}  // namespace carom
