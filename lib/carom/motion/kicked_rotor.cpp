#include "carom/motion/kicked_rotor.hpp"

#include "carom/core/checks.hpp"

namespace carom {

RotorState kickedRotor(const SplitRotor& body, const RotorState& state, Real time, Real dt,
                       std::span<const Real> weights, const Torque& torque) {
  requireUsable(state);
  requireFinite(time, "time");
  requireFinite(dt, "dt");
  if (!torque) reject("torque", "an empty function", "must be callable");
  RotorState next = state;
  Real turn = 0, done = 0;  // how much free turning is owed, and how far the kicks have come [1]
  for (const Real w : weights) {
    next = body.step4(next, (turn + w / 2) * dt);
    const Vector3 tau = torque(time + (done + w / 2) * dt, next);
    next.angularVelocity += w * dt * tau.cwiseQuotient(body.moments());
    turn = w / 2;
    done += w;
  }
  return body.step4(next, turn * dt);
}

}  // namespace carom
