// Exercise 05.impulse_3d: how hard do two bodies of any shape hit each other?
// Check it with: ./course check 05.impulse_3d

#include "carom/impulse/impulse_3d.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"
#include "carom/impulse/point_velocity.hpp"

namespace carom {

Real impulse3d(const MovingBody& a, const MovingBody& b, const Contact& contact, Real restitution) {
  // Given: what cannot be worked with is refused.
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  // pointVelocity(velocity, arm) is the velocity of a point of a body.
  return todo<Real>("impulse3d");
}

}  // namespace carom
