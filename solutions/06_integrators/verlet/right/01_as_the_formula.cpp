// 2 x(i) - x(i-1) + a dt^2, as it is written in books.
#include "carom/core/errors.hpp"
#include "carom/motion/verlet.hpp"

namespace carom {

TwoPositions verlet(const TwoPositions& positions, Real time, Real dt,
                    const Acceleration& acceleration) {
  if (dt == 0) throw InvalidInput("dt must not be zero");
  requireUsable({positions.previous, positions.current}, time, dt);
  const Coordinates none = Coordinates::Zero(positions.current.size());
  const Coordinates a = accelerationAt(acceleration, time, positions.current, none);
  return {positions.current, 2 * positions.current - positions.previous + a * dt * dt};
}

}  // namespace carom
