// Exercise 05.impulse_3d: how hard do two bodies of any shape hit each other?
// Check it with: ./course check 05.impulse_3d

#include "carom/impulse/impulse_3d.hpp"

#include "carom/core/cross.hpp"
#include "carom/impulse/point_velocity.hpp"

namespace carom {

Real impulse3d(const MovingBody& a, const MovingBody& b, const Contact& contact, Real restitution) {
  // Given: what cannot be worked with is refused.
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  const Vector3& n = contact.normal;
  const Vector3 pointA = pointVelocity(a.velocity, contact.armA);
  const Vector3 pointB = pointVelocity(b.velocity, contact.armB);
  const Real parting = (pointB - pointA).dot(n);
  if (parting >= 0) return 0;

  const Vector3 torqueA = cross(contact.armA, n);
  const Vector3 torqueB = cross(contact.armB, n);
  const Real turningA = torqueA.dot(a.mass.inverseInertia * torqueA);
  const Real turningB = torqueB.dot(b.mass.inverseInertia * torqueB);
  const Real inverseMass = a.mass.inverseMass + b.mass.inverseMass + turningA + turningB;
  return inverseMass > 0 ? -restitution * parting / inverseMass : 0;
}

}  // namespace carom
