#include "carom/motion/semi_implicit_euler.hpp"

namespace carom {

State semiImplicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const Coordinates a = accelerationAt(acceleration, time, state.position, state.velocity);
  const Coordinates velocity = state.velocity + dt * a;
  return {state.position + dt * velocity, velocity};
}

}  // namespace carom
