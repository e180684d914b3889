// Exercise 05.impulse_2d: how hard do two bodies in the plane hit each other?
// Check it with: ./course check 05.impulse_2d

#include "carom/impulse/impulse_2d.hpp"

#include "carom/core/todo.hpp"
#include "carom/impulse/planar_motion.hpp"

namespace carom {

Real impulse2d(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
               Real restitution) {
  // Given: what cannot be worked with is refused.
  requireUsable(a, "a");
  requireUsable(b, "b");
  requireUsable(contact);
  requireRestitution(restitution);
  // planarPointVelocity(velocity, arm) is the velocity of a point of a body, a Vector2, and
  // planarCross(r, n) the cross product r x n, a number.
  return todo<Real>("impulse2d");
}

}  // namespace carom
