// Coordinate by coordinate, in a copy of the state.
#include "carom/motion/explicit_euler.hpp"

namespace carom {

State explicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const Coordinates a = accelerationAt(acceleration, time, state.position, state.velocity);
  State next = state;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    next.position[i] += state.velocity[i] * dt;
    next.velocity[i] += a[i] * dt;
  }
  return next;
}

}  // namespace carom
