#include "carom/impulse/impulse_2d.hpp"

#include "carom/impulse/planar_motion.hpp"

namespace carom {

Real impulse2d(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
               Real restitution) {
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  const Vector2& n = contact.normal;

  // How fast B's point moves away from A's, along the normal.
  const Vector2 u =
      planarPointVelocity(b.velocity, contact.armB) - planarPointVelocity(a.velocity, contact.armA);
  const Real parting = u.dot(n);
  if (parting >= 0) return 0;

  // What a unit impulse would add to that.
  const Real torqueA = planarCross(contact.armA, n);
  const Real torqueB = planarCross(contact.armB, n);
  const Real inverseMass = a.mass.inverseMass + b.mass.inverseMass +
                           torqueA * torqueA * a.mass.inverseInertia +
                           torqueB * torqueB * b.mass.inverseInertia;
  return inverseMass > 0 ? -(1 + restitution) * parting / inverseMass : 0;
}

}  // namespace carom
