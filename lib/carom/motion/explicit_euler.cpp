#include "carom/motion/explicit_euler.hpp"

namespace carom {

State explicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const Coordinates a = accelerationAt(acceleration, time, state.position, state.velocity);
  return {state.position + dt * state.velocity, state.velocity + dt * a};
}

}  // namespace carom
