#include "carom/motion/rotor.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom/rotation/scaled_quaternion.hpp"

namespace carom {

Vector3 angularMomentum(const Vector3& moments, const RotorState& state) {
  return rotatePoint(state.q_WB, moments.cwiseProduct(state.angularVelocity));
}

Real rotationEnergy(const Vector3& moments, const Vector3& angularVelocity) {
  return moments.cwiseProduct(angularVelocity).dot(angularVelocity) / 2;
}

Vector3 eulerAcceleration(const Vector3& moments, const Vector3& angularVelocity,
                          const Vector3& torque) {
  const Vector3 momentum = moments.cwiseProduct(angularVelocity);
  return (torque - cross(angularVelocity, momentum)).cwiseQuotient(moments);
}

void requireMoments(const Vector3& moments) {
  if (!(moments.minCoeff() > 0) || !moments.allFinite()) {
    reject("moments", toText(moments), "must be positive and finite");
  }
}

void requireUsable(const RotorState& state) {
  const Quaternion& q = state.q_WB;
  // Rounding leaves 1e-15; what was typed with seven digits may pass too.
  if (!(std::abs(squaredNorm(q) - 1) < 2e-6)) {
    reject("q_WB", toText(Vector4(q.w, q.x, q.y, q.z)), "must be finite and of norm one");
  }
  requireFinite(state.angularVelocity, "angularVelocity");
}

}  // namespace carom
