// Exercise 01.turning_errors: how good is a method of turning?
// Check it with: ./course check 01.turning_errors

#include "turning_errors.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/core/todo.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"

namespace carom {

std::vector<TurningError> turningErrors(const TurningStep& step, const Quaternion& start,
                                        const Quaternion& end, Real duration,
                                        std::span<const int> counts) {
  requireFinite(duration, "duration");
  for (const int steps : counts) {
    if (steps < 1) reject("count", std::to_string(steps), "must be at least 1");
  }

  // For each count: begin at the start, make the steps, and add a row {count, dt, error}.
  return todo<std::vector<TurningError>>("turningErrors");
}

}  // namespace carom
