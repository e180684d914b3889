#pragma once
// Two billiard balls meet: the physics of the chapter's first two programs, on one screen.
//
// Fly straight, and when two balls overlap and approach one another, exchange an impulse along the
// line of their centres. The balls slide without friction and do not spin; the table is seen from
// above. Not handled: the exact moment of contact, which lies somewhere within the step.

#include "carom/core/real.hpp"

/// The physics of two balls that meet on a table, for the first programs.
namespace two_balls {

using carom::Real;
using carom::Vector2;

//! [constants]
constexpr Real kRadius = 0.028575;  ///< [m]: a pool ball is 57.15 mm across
constexpr Real kMass = 0.17;        ///< [kg]
//! [constants]

/// A ball on the table.
//! [state]
struct Ball {
  Vector2 position;  ///< of the centre [m]
  Vector2 velocity;  ///< [m/s]
};
//! [state]

/// The two balls, as they stand at the beginning: blue comes from the left, red rests a little off
/// its path.
struct Pair {
  Ball blue{{-0.3, 0.0}, {0.5, 0.0}};  ///< the one that comes
  Ball red{{0.0, 0.02}, {0.0, 0.0}};   ///< the one that is hit
};

/// What a contact does to two velocities; nothing if the balls do not overlap.
/// \param a one ball \param b the other
/// \param restitution speed apart divided by speed of approach [1]
/// \param askFirst whether a pair that is already on its way apart is left alone; false shows what
/// happens then
/// \source{27,28}
/// \erratum{6.3}
//! [impulse]
inline void collide(Ball& a, Ball& b, Real restitution, bool askFirst = true) {
  const Vector2 offset = b.position - a.position;
  const Real distance = offset.norm();
  if (distance > 2 * kRadius) return;  // apart

  const Vector2 normal = offset / distance;                   // from a to b
  const Real approach = normal.dot(a.velocity - b.velocity);  // [m/s], positive while they close in
  if (askFirst && approach <= 0) return;                      // already on their way apart

  const Real impulse = (1 + restitution) * approach / (1 / kMass + 1 / kMass);  // [N s]
  a.velocity -= impulse / kMass * normal;
  b.velocity += impulse / kMass * normal;
}
//! [impulse]

/// Moves the pair by one step of time.
/// \param pair the balls \param dt the step [s]
/// \param restitution see collide() \param askFirst see collide()
//! [step]
inline void step(Pair& pair, Real dt, Real restitution, bool askFirst = true) {
  pair.blue.position += dt * pair.blue.velocity;
  pair.red.position += dt * pair.red.velocity;
  collide(pair.blue, pair.red, restitution, askFirst);
}
//! [step]

/// The momentum of both balls together. \param pair the balls \return momentum [N s]
//! [conserved]
inline Vector2 momentum(const Pair& pair) {
  return kMass * pair.blue.velocity + kMass * pair.red.velocity;
}
//! [conserved]

/// The kinetic energy of both balls together. \param pair the balls \return energy [J]
//! [energy]
inline Real energy(const Pair& pair) {
  return kMass / 2 * (pair.blue.velocity.squaredNorm() + pair.red.velocity.squaredNorm());
}
//! [energy]

}  // namespace two_balls
