// Exercise 05.angular_acceleration: how fast does the rotation of a body change?
// Check it with: ./course check 05.angular_acceleration

#include "carom/impulse/angular_acceleration.hpp"

#include "carom/core/checks.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/positive_solve.hpp"

namespace carom {

Vector3 angularAcceleration(const Matrix3& inertia, const Vector3& angularVelocity,
                            const Vector3& torque) {
  // Given: what cannot be is refused.
  requireInertia(inertia);
  requireFinite(angularVelocity, "angularVelocity");
  requireFinite(torque, "torque");
  return PositiveSolve(inertia).solve(torque);
}

}  // namespace carom
