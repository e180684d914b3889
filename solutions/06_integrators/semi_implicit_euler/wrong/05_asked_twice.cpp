// Exercise 06.semi_implicit_euler: what does it change to use the new velocity at once?
// Check it with: ./course check 06.semi_implicit_euler

#include "carom/motion/semi_implicit_euler.hpp"

namespace carom {

State semiImplicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable(state, time, dt);
  const Coordinates a = accelerationAt(acceleration, time, state.position, state.velocity);
  Coordinates velocity = state.velocity + dt * a;
  velocity += dt * accelerationAt(acceleration, time, state.position, velocity);
  return {state.position + dt * velocity, velocity};
}

}  // namespace carom
