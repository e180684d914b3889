// Exercise 05.rolling_friction: why does a ball that rolls on a level table stop at all?
// Check it with: ./course check 05.rolling_friction

#include "carom/impulse/rolling_friction.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Vector3 rollingFriction(const RollingContact& contact) {
  // Given: what cannot be is refused.
  requireFinite(contact.angularVelocity, "angularVelocity");
  requireFinite(contact.normal, "normal");
  requirePositive(contact.inertia, "inertia");
  requireNonNegative(contact.normalImpulse, "normalImpulse");
  requireNonNegative(contact.arm, "arm");
  const Vector3& w = contact.angularVelocity;
  const Vector3 rolling = w - w.dot(contact.normal) * contact.normal;
  const Real rate = length(rolling);
  if (rate == 0) return Vector3::Zero();

  const Real toStop = contact.inertia * rate;
  const Real atMost = contact.arm * contact.normalImpulse;
  return -std::min(toStop, atMost) * rolling;
}

}  // namespace carom
