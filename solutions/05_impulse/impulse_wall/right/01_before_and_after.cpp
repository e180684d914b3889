// Compares the speed of the point without and with an impulse of 1 N s.
#include <algorithm>

#include "carom/core/cross.hpp"
#include "carom/impulse/impulse_wall.hpp"
#include "carom/impulse/point_velocity.hpp"

namespace carom {

Real impulseWall(const MovingBody& body, const Vector3& arm, const Vector3& normal,
                 Real restitution) {
  requireUsable(body, "body");
  requireUsable(Contact{normal, Vector3::Zero(), arm});
  requireRestitution(restitution);
  const Velocity gained = {body.mass.inverseMass * normal,
                           body.mass.inverseInertia * cross(arm, normal)};
  const Real perUnit = normal.dot(pointVelocity(gained, arm));
  const Real approach = -normal.dot(pointVelocity(body.velocity, arm));
  if (perUnit <= 0) return 0;
  return std::max(0.0, approach + restitution * approach) / perUnit;
}

}  // namespace carom
