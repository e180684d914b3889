#include "carom/impulse/impulse_3d.hpp"

#include "carom/core/cross.hpp"
#include "carom/impulse/point_velocity.hpp"

namespace carom {

Real impulse3d(const MovingBody& a, const MovingBody& b, const Contact& contact, Real restitution) {
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  const Vector3& n = contact.normal;

  // How fast B's point moves away from A's, along the normal.
  const Vector3 u =
      pointVelocity(b.velocity, contact.armB) - pointVelocity(a.velocity, contact.armA);
  const Real parting = u.dot(n);
  if (parting >= 0) return 0;

  // What a unit impulse would add to that: by pushing the centres, and by turning the bodies.
  const Vector3 torqueA = cross(contact.armA, n);
  const Vector3 torqueB = cross(contact.armB, n);
  const Real inverseMass = a.mass.inverseMass + b.mass.inverseMass +
                           torqueA.dot(a.mass.inverseInertia * torqueA) +
                           torqueB.dot(b.mass.inverseInertia * torqueB);
  return inverseMass > 0 ? -(1 + restitution) * parting / inverseMass : 0;
}

}  // namespace carom
