// Tries an impulse of 1 N s, looks what it does, and scales it.
#include <algorithm>

#include "carom/impulse/impulse_2d.hpp"
#include "carom/impulse/planar_motion.hpp"

namespace carom {

namespace {

Real parting(const PlanarVelocity& a, const PlanarVelocity& b, const PlanarContact& contact) {
  return contact.normal.dot(planarPointVelocity(b, contact.armB)) -
         contact.normal.dot(planarPointVelocity(a, contact.armA));
}

PlanarVelocity pushed(const PlanarBody& body, const Vector2& arm, const Vector2& impulse) {
  return {body.velocity.linear + body.mass.inverseMass * impulse,
          body.velocity.angular + body.mass.inverseInertia * planarCross(arm, impulse)};
}

}  // namespace

Real impulse2d(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
               Real restitution) {
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  const Real before = parting(a.velocity, b.velocity, contact);
  const Real tried = parting(pushed(a, contact.armA, -contact.normal),
                             pushed(b, contact.armB, contact.normal), contact);
  if (before >= 0 || tried <= before) return 0;
  return (-restitution * before - before) / (tried - before);
}

}  // namespace carom
