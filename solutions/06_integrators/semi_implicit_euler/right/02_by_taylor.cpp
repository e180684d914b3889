// With the new velocity written out: x + v dt + a dt^2. The a dt^2 is not halved.
#include "carom/motion/semi_implicit_euler.hpp"

namespace carom {

State semiImplicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const Coordinates kick = dt * accelerationAt(acceleration, time, state.position, state.velocity);
  return {state.position + dt * state.velocity + dt * kick, state.velocity + kick};
}

}  // namespace carom
