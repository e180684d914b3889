// The new velocity is guessed, and guessed again with the force that follows, until it settles.
#include "carom/motion/velocity_verlet.hpp"

namespace carom {

State velocityVerlet(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const Coordinates a0 = accelerationAt(acceleration, time, state.position, state.velocity);
  State next = {state.position + dt * (state.velocity + dt / 2 * a0), state.velocity + dt * a0};
  for (int i = 0; i < 4; ++i) {
    const Coordinates a1 = accelerationAt(acceleration, time + dt, next.position, next.velocity);
    next.velocity = state.velocity + dt / 2 * (a0 + a1);
  }
  return next;
}

}  // namespace carom
