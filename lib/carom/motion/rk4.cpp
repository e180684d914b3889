#include "carom/motion/rk4.hpp"

namespace carom {
namespace {

// The slope of a state: velocities, and accelerations.
State slope(const State& y, Real time, const Acceleration& acceleration) {
  return {y.velocity, accelerationAt(acceleration, time, y.position, y.velocity)};
}

State along(const State& y, Real dt, const State& k) {
  return {y.position + dt * k.position, y.velocity + dt * k.velocity};
}

}  // namespace

State rk4(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  const State k1 = slope(state, time, acceleration);
  const State k2 = slope(along(state, dt / 2, k1), time + dt / 2, acceleration);
  const State k3 = slope(along(state, dt / 2, k2), time + dt / 2, acceleration);
  const State k4 = slope(along(state, dt, k3), time + dt, acceleration);

  const State sum = {k1.position + 2 * k2.position + 2 * k3.position + k4.position,
                     k1.velocity + 2 * k2.velocity + 2 * k3.velocity + k4.velocity};
  return along(state, dt / 6, sum);
}

}  // namespace carom
