// The mean velocity of the last step, changed by a dt, is that of the next one.
#include "carom/core/errors.hpp"
#include "carom/motion/verlet.hpp"

namespace carom {

TwoPositions verlet(const TwoPositions& positions, Real time, Real dt,
                    const Acceleration& acceleration) {
  requireUsable({positions.previous, positions.current}, time, dt);
  if (dt == 0) throw InvalidInput("dt must not be zero");
  Coordinates velocity = (positions.current - positions.previous) / dt;
  velocity += accelerationAt(acceleration, time, positions.current, velocity) * dt;
  return {positions.current, positions.current + velocity * dt};
}

}  // namespace carom
