// Equation 32 of the source as it stands: n . ((I^-1 (r x n)) x r).
#include "carom/core/cross.hpp"
#include "carom/impulse/impulse_3d.hpp"

namespace carom {

Real impulse3d(const MovingBody& a, const MovingBody& b, const Contact& contact, Real restitution) {
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  const Vector3 n = contact.normal;
  const Vector3 rA = contact.armA, rB = contact.armB;
  const Vector3 relative = b.velocity.linear + cross(b.velocity.angular, rB) - a.velocity.linear -
                           cross(a.velocity.angular, rA);
  const Vector3 turned = cross(a.mass.inverseInertia * cross(rA, n), rA) +
                         cross(b.mass.inverseInertia * cross(rB, n), rB);
  const Real denominator = a.mass.inverseMass + b.mass.inverseMass + n.dot(turned);
  const Real approach = -relative.dot(n);
  return approach > 0 && denominator > 0 ? (1 + restitution) * approach / denominator : 0;
}

}  // namespace carom
