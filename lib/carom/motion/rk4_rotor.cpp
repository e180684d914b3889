#include "carom/motion/rk4_rotor.hpp"

#include "carom/core/checks.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {
namespace {

// A rate of change, in the shape of what it changes.
RotorState rate(const Vector3& moments, const RotorState& s, Real time, const Torque& torque) {
  const Vector3& w = s.angularVelocity;
  const Quaternion q = hamiltonProduct(s.q_WB, {0, w.x() / 2, w.y() / 2, w.z() / 2});
  const Vector3 tau = torque ? torque(time, s) : Vector3::Zero();
  return {q, eulerAcceleration(moments, w, tau)};
}

RotorState along(const RotorState& s, Real dt, const RotorState& k) {
  return {{s.q_WB.w + dt * k.q_WB.w, s.q_WB.x + dt * k.q_WB.x, s.q_WB.y + dt * k.q_WB.y,
           s.q_WB.z + dt * k.q_WB.z},
          s.angularVelocity + dt * k.angularVelocity};
}

}  // namespace

RotorState rk4Rotor(const Vector3& moments, const RotorState& state, Real time, Real dt,
                    const Torque& torque) {
  requireMoments(moments);
  requireUsable(state);
  requireFinite(time, "time");
  requireFinite(dt, "dt");
  const RotorState k1 = rate(moments, state, time, torque);
  const RotorState k2 = rate(moments, along(state, dt / 2, k1), time + dt / 2, torque);
  const RotorState k3 = rate(moments, along(state, dt / 2, k2), time + dt / 2, torque);
  const RotorState k4 = rate(moments, along(state, dt, k3), time + dt, torque);
  RotorState next =
      along(along(along(along(state, dt / 6, k1), dt / 3, k2), dt / 3, k3), dt / 6, k4);
  next.q_WB = renormalize(next.q_WB);
  return next;
}

}  // namespace carom
