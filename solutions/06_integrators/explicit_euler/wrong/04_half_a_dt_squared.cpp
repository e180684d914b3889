// Exercise 06.explicit_euler: where is everything a step later, if nothing changed meanwhile?
// Check it with: ./course check 06.explicit_euler

#include "carom/motion/explicit_euler.hpp"

namespace carom {

State explicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable(state, time, dt);
  const Coordinates a = accelerationAt(acceleration, time, state.position, state.velocity);
  return {state.position + dt * state.velocity + dt * dt / 2 * a, state.velocity + dt * a};
}

}  // namespace carom
