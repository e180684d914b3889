#include "carom/motion/explicit_gyroscopic_step.hpp"

#include "carom/core/checks.hpp"
#include "carom/motion/rotor.hpp"

namespace carom {

Vector3 explicitGyroscopicStep(const Vector3& moments, const Vector3& angularVelocity, Real dt) {
  requireMoments(moments);
  requireFinite(angularVelocity, "angularVelocity");
  requireFinite(dt, "dt");
  return angularVelocity + dt * eulerAcceleration(moments, angularVelocity, Vector3::Zero());
}

}  // namespace carom
