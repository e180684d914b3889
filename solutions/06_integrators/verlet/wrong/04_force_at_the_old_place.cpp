// Exercise 06.verlet: where is everything next, if we know where it was at two moments?
// Check it with: ./course check 06.verlet

#include "carom/motion/verlet.hpp"

#include "carom/core/checks.hpp"

namespace carom {

TwoPositions verlet(const TwoPositions& positions, Real time, Real dt,
                    const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable({positions.previous, positions.current}, time, dt);
  if (dt == 0) reject("dt", toText(dt), "must not be zero");
  const Coordinates step = positions.current - positions.previous;
  const Coordinates a = accelerationAt(acceleration, time, positions.previous, step / dt);
  return {positions.current, positions.current + step + dt * dt * a};
}

}  // namespace carom
