// Exercise 06.velocity_verlet: how does Verlet's method look with a velocity in it?
// Check it with: ./course check 06.velocity_verlet

#include "carom/motion/velocity_verlet.hpp"

namespace carom {

State velocityVerlet(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable(state, time, dt);
  const Coordinates before = accelerationAt(acceleration, time, state.position, state.velocity);
  const Coordinates position = state.position + dt * state.velocity + dt * dt / 2 * before;
  const Coordinates after = accelerationAt(acceleration, time, state.position, state.velocity);
  return {position, state.velocity + dt / 2 * (before + after)};
}

}  // namespace carom
