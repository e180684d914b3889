#include "carom/motion/verlet_start.hpp"

#include "carom/core/checks.hpp"

namespace carom {

TwoPositions verletStart(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  if (dt == 0) reject("dt", toText(dt), "must not be zero");
  const Coordinates a = accelerationAt(acceleration, time, state.position, state.velocity);
  return {state.position - dt * state.velocity + dt * dt / 2 * a, state.position};
}

State verletState(const TwoPositions& positions, Real time, Real dt,
                  const Acceleration& acceleration) {
  const TwoPositions next = verlet(positions, time, dt, acceleration);
  return {positions.current, (next.current - positions.previous) / (2 * dt)};
}

}  // namespace carom
