// Exercise 06.rk4: can four looks at the forces do better than one?
// Check it with: ./course check 06.rk4

#include "carom/motion/rk4.hpp"

namespace carom {

State rk4(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable(state, time, dt);
  const auto slope = [&](Real t, const State& y) -> State {
    return {y.velocity, accelerationAt(acceleration, t, y.position, y.velocity)};
  };
  const auto along = [&](Real h, const State& k) -> State {
    return {state.position + h * k.position, state.velocity + h * k.velocity};
  };
  const State k1 = slope(time, state);
  const State k2 = slope(time + dt / 2, along(dt / 2, k1));
  const State k3 = slope(time + dt / 2, along(dt / 2, k2));
  const State k4 = slope(time + dt, along(dt, k3));

  const State sum = {k1.position + k2.position + k3.position + k4.position,
                     k1.velocity + k2.velocity + k3.velocity + k4.velocity};
  return along(dt / 4, sum);
}

}  // namespace carom
