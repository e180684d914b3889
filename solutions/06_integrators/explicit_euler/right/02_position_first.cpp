// In place, and the position first: then the velocity in it is still the old one.
#include "carom/motion/explicit_euler.hpp"

namespace carom {

State explicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  State now = state;
  const Coordinates change = accelerationAt(acceleration, time, now.position, now.velocity) * dt;
  now.position += now.velocity * dt;
  now.velocity += change;
  return now;
}

}  // namespace carom
