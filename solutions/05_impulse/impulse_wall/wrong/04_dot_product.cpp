// Exercise 05.impulse_wall: how hard does a body hit a wall?
// Check it with: ./course check 05.impulse_wall

#include "carom/impulse/impulse_wall.hpp"

#include "carom/core/cross.hpp"
#include "carom/impulse/point_velocity.hpp"

namespace carom {

Real impulseWall(const MovingBody& body, const Vector3& arm, const Vector3& normal,
                 Real restitution) {
  // Given: what cannot be worked with is refused.
  requireUsable(body, "body");
  requireUsable(Contact{normal, Vector3::Zero(), arm});
  requireRestitution(restitution);
  const Real parting = pointVelocity(body.velocity, arm).dot(normal);
  if (parting >= 0) return 0;

  const Vector3 torque = arm.dot(normal) * normal;
  const Real inverseMass = body.mass.inverseMass + torque.dot(body.mass.inverseInertia * torque);
  return inverseMass > 0 ? -(1 + restitution) * parting / inverseMass : 0;
}

}  // namespace carom
