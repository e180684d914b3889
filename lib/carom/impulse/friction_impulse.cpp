#include "carom/impulse/friction_impulse.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Vector3 frictionImpulse(const Vector3& relativeVelocity, const Vector3& normal, Real normalImpulse,
                        Real friction, Real tangentialMass) {
  requireFinite(relativeVelocity, "relativeVelocity");
  requireFinite(normal, "normal");
  requireNonNegative(normalImpulse, "normalImpulse");
  requireNonNegative(friction, "friction");
  requirePositive(tangentialMass, "tangentialMass");

  const Vector3 slip = relativeVelocity - relativeVelocity.dot(normal) * normal;
  const Real speed = length(slip);
  if (speed == 0) return Vector3::Zero();
  const Vector3 direction = slip / speed;

  const Real toStop = tangentialMass * speed;    // sticking needs this much
  const Real atMost = friction * normalImpulse;  // the cone allows this much
  return -std::min(toStop, atMost) * direction;
}

}  // namespace carom
