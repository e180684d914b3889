// With the inverse matrix, and the cross product the other way round.
#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/impulse/angular_acceleration.hpp"
#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/positive_solve.hpp"

namespace carom {

Vector3 angularAcceleration(const Matrix3& inertia, const Vector3& angularVelocity,
                            const Vector3& torque) {
  requireInertia(inertia);
  requireFinite(angularVelocity, "angularVelocity");
  requireFinite(torque, "torque");
  const Matrix3 inverse = PositiveSolve(inertia).inverse();
  const Vector3 gyroscopic = cross(inertia * angularVelocity, angularVelocity);
  return inverse * torque + inverse * gyroscopic;
}

}  // namespace carom
