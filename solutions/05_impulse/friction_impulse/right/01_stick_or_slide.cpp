// First tries to stick, and slides if the cone does not allow it.
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/impulse/friction_impulse.hpp"

namespace carom {

Vector3 frictionImpulse(const Vector3& relativeVelocity, const Vector3& normal, Real normalImpulse,
                        Real friction, Real tangentialMass) {
  if (!relativeVelocity.allFinite() || !normal.allFinite() || !(normalImpulse >= 0) ||
      !(friction >= 0) || !(tangentialMass > 0)) {
    throw InvalidInput("frictionImpulse: no such contact");
  }
  // (n x v) x n is what is left of v across n; the source has its opposite.
  const Vector3 slip = cross(cross(normal, relativeVelocity), normal);
  const Vector3 stick = -tangentialMass * slip;
  const Real size = stick.norm();
  if (size <= friction * normalImpulse) return stick;
  return stick / size * (friction * normalImpulse);
}

}  // namespace carom
