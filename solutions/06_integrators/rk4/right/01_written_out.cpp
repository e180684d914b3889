// Positions and velocities apart, and the sum gathered on the way.
#include "carom/motion/rk4.hpp"

namespace carom {

State rk4(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const Coordinates &x = state.position, &v = state.velocity;
  const Real half = dt / 2;
  const Coordinates a1 = accelerationAt(acceleration, time, x, v);
  const Coordinates v2 = v + half * a1;
  const Coordinates a2 = accelerationAt(acceleration, time + half, x + half * v, v2);
  const Coordinates v3 = v + half * a2;
  const Coordinates a3 = accelerationAt(acceleration, time + half, x + half * v2, v3);
  const Coordinates v4 = v + dt * a3;
  const Coordinates a4 = accelerationAt(acceleration, time + dt, x + dt * v3, v4);
  return {x + dt * (v + 2 * (v2 + v3) + v4) / 6, v + dt * (a1 + 2 * (a2 + a3) + a4) / 6};
}

}  // namespace carom
