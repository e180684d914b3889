#pragma once
// What does a beginner's solver keep of one contact among many?
//
// One condition, called a row: at one point, along one direction, two bodies must not approach
// faster than is allowed. Two numbers of the bodies, the contact of chapter 5, and what is to be
// remembered: the sum of all impulses that the row has given.
// Why one row per point and nothing shared: a row can be understood, and written, by itself.
// contact_patch.hpp is what the world uses: rows of one face together, with their friction.
// Source: Catto, GDC 2006.
// Not handled: friction (friction_pyramid_to_cone.hpp).

#include <span>

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/effective_mass.hpp"

namespace carom {

/// One contact among many. \ingroup solver
struct ContactRow {
  int bodyA = 0;        ///< number of body A
  int bodyB = 0;        ///< number of body B
  Contact contact;      ///< normal from A to B, and the two arms [world]
  int name = 0;         ///< the same contact has the same name in every step
  Real separation = 0;  ///< between the bodies; negative: overlap [m]
  Real target = 0;      ///< at least this fast they have to part; negative: may approach [m/s]
  Real impulse = 0;     ///< the sum of what the row has given in this step, on B [N s]
};

/// How fast the bodies of a row part. \param row any row \param bodies as they move
/// \return speed along the normal, negative if they approach [m/s] \ingroup solver
inline Real partingSpeed(const ContactRow& row, std::span<const MovingBody> bodies) {
  return row.contact.normal.dot(
      relativeVelocity(bodies[row.bodyA], bodies[row.bodyB], row.contact));
}

/// How much impulse changes the parting speed of a row by 1 m/s. \param row any row
/// \param bodies their masses \return effective mass along the normal [kg] \ingroup solver
inline Real rowMass(const ContactRow& row, std::span<const MovingBody> bodies) {
  return effectiveMass(bodies[row.bodyA].mass, bodies[row.bodyB].mass, row.contact);
}

/// Pushes the bodies of a row apart; does not count it. \param row any row
/// \param impulse along the normal, on B; A gets the opposite [N s]
/// \param bodies their velocities are changed \ingroup solver
inline void pushRow(const ContactRow& row, Real impulse, std::span<MovingBody> bodies) {
  changeVelocities(bodies[row.bodyA], bodies[row.bodyB], row.contact, impulse * row.contact.normal);
}

}  // namespace carom
