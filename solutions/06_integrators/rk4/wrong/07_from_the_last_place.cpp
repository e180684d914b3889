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
  const auto along = [](const State& from, Real h, const State& k) -> State {
    return {from.position + h * k.position, from.velocity + h * k.velocity};
  };
  const State k1 = slope(time, state);
  const State second = along(state, dt / 2, k1);
  const State k2 = slope(time + dt / 2, second);
  const State third = along(second, dt / 2, k2);
  const State k3 = slope(time + dt / 2, third);
  const State k4 = slope(time + dt, along(third, dt, k3));

  const State sum = {k1.position + 2 * k2.position + 2 * k3.position + k4.position,
                     k1.velocity + 2 * k2.velocity + 2 * k3.velocity + k4.velocity};
  return along(state, dt / 6, sum);
}

}  // namespace carom
