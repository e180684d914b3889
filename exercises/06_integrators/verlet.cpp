// Exercise 06.verlet: where is everything next, if we know where it was at two moments?
// Check it with: ./course check 06.verlet

#include "carom/motion/verlet.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

TwoPositions verlet(const TwoPositions& positions, Real time, Real dt,
                    const Acceleration& acceleration) {
  // Given: numbers that cannot be worked with are refused.
  requireUsable({positions.previous, positions.current}, time, dt);
  if (dt == 0) reject("dt", toText(dt), "must not be zero");
  // accelerationAt(acceleration, time, position, velocity) wants a velocity too. This method has
  // none, and its forces do not look at it: give it (current - previous) / dt.
  return todo<TwoPositions>("verlet");
}

}  // namespace carom
