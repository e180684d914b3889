// Half a kick, a drift, half a kick. The guess of the velocity has the whole kick.
#include "carom/motion/velocity_verlet.hpp"

namespace carom {

State velocityVerlet(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  State now = state;
  const Coordinates kick = dt / 2 * accelerationAt(acceleration, time, now.position, now.velocity);
  now.velocity += kick;
  now.position += dt * now.velocity;
  const Coordinates guess = now.velocity + kick;
  now.velocity += dt / 2 * accelerationAt(acceleration, time + dt, now.position, guess);
  return now;
}

}  // namespace carom
