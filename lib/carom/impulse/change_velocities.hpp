#pragma once
// The same as applyImpulse(), for bodies whose inertia lies along the world's axes already.
//
// Impact laws and solvers turn each tensor once and then push many times. No checks: what comes
// here was checked before. This header is for the library and for programs that step a world.

#include "carom/core/cross.hpp"
#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/planar_motion.hpp"

namespace carom {

/// Changes the velocities of two bodies by an impulse between them.
/// \param a gets -impulse \param b gets +impulse
/// \param contact where it acts; the normal is not used \param impulse [N s, world]
/// \ingroup impulse
inline void changeVelocities(MovingBody& a, MovingBody& b, const Contact& contact,
                             const Vector3& impulse) {
  a.velocity.linear -= a.mass.inverseMass * impulse;
  a.velocity.angular -= a.mass.inverseInertia * cross(contact.armA, impulse);
  b.velocity.linear += b.mass.inverseMass * impulse;
  b.velocity.angular += b.mass.inverseInertia * cross(contact.armB, impulse);
}

/// Changes the velocities of two planar bodies by an impulse between them.
/// \param a gets -impulse \param b gets +impulse
/// \param contact where it acts; the normal is not used \param impulse [N s, world]
/// \ingroup impulse
inline void changeVelocities(PlanarBody& a, PlanarBody& b, const PlanarContact& contact,
                             const Vector2& impulse) {
  a.velocity.linear -= a.mass.inverseMass * impulse;
  a.velocity.angular -= a.mass.inverseInertia * planarCross(contact.armA, impulse);
  b.velocity.linear += b.mass.inverseMass * impulse;
  b.velocity.angular += b.mass.inverseInertia * planarCross(contact.armB, impulse);
}

/// The velocity of B's point against A's, u. \param a body A \param b body B
/// \param contact where they touch \return u; they approach if u . normal < 0 [m/s, world]
/// \source{39}
/// \ingroup impulse
inline Vector3 relativeVelocity(const MovingBody& a, const MovingBody& b, const Contact& contact) {
  return b.velocity.linear + cross(b.velocity.angular, contact.armB) - a.velocity.linear -
         cross(a.velocity.angular, contact.armA);
}

/// The velocity of B's point against A's in the plane, u. \param a body A \param b body B
/// \param contact where they touch \return u; they approach if u . normal < 0 [m/s, world]
/// \ingroup impulse
inline Vector2 relativeVelocity(const PlanarBody& a, const PlanarBody& b,
                                const PlanarContact& contact) {
  return planarPointVelocity(b.velocity, contact.armB) -
         planarPointVelocity(a.velocity, contact.armA);
}

}  // namespace carom
