// Exercise 05.impulse_wall: how hard does a body hit a wall?
// Check it with: ./course check 05.impulse_wall

#include "carom/impulse/impulse_wall.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"
#include "carom/impulse/point_velocity.hpp"

namespace carom {

Real impulseWall(const MovingBody& body, const Vector3& arm, const Vector3& normal,
                 Real restitution) {
  // Given: what cannot be worked with is refused.
  requireUsable(body, "body");
  requireUsable(Contact{normal, Vector3::Zero(), arm});
  requireRestitution(restitution);
  // pointVelocity(body.velocity, arm) is the velocity of the point that hits the wall.
  return todo<Real>("impulseWall");
}

}  // namespace carom
