// In place, as the listing of section 7.1 goes.
#include "carom/motion/semi_implicit_euler.hpp"

namespace carom {

State semiImplicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration) {
  requireUsable(state, time, dt);
  State now = state;
  now.velocity += accelerationAt(acceleration, time, now.position, now.velocity) * dt;
  now.position += now.velocity * dt;
  return now;
}

}  // namespace carom
