// Exercise 05.impulse_2d: how hard do two bodies in the plane hit each other?
// Check it with: ./course check 05.impulse_2d

#include "carom/impulse/impulse_2d.hpp"

#include "carom/impulse/planar_motion.hpp"

namespace carom {

Real impulse2d(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
               Real restitution) {
  // Given: what cannot be worked with is refused.
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  const Vector2& n = contact.normal;
  const Vector2 pointA = planarPointVelocity(a.velocity, contact.armA);
  const Vector2 pointB = planarPointVelocity(b.velocity, contact.armB);
  const Real parting = (pointB - pointA).dot(n);
  if (parting >= 0) return 0;

  const Real torqueA = planarCross(contact.armA, n);
  const Real torqueB = planarCross(contact.armB, n);
  const Real inverseMass = a.mass.inverseMass + b.mass.inverseMass +
                           torqueA * torqueA * a.mass.inverseInertia +
                           torqueB * torqueB * b.mass.inverseInertia;
  return inverseMass > 0 ? -restitution * parting / inverseMass : 0;
}

}  // namespace carom
