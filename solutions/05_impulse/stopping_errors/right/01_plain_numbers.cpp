// Without vectors: friction takes the same from the speed in each step, until less is left.
#include <algorithm>

#include "carom/core/errors.hpp"
#include "stopping_errors.hpp"

namespace carom {

std::vector<StoppingError> stoppingErrors(Real speed, Real friction, std::span<const Real> steps) {
  if (!(speed > 0) || !(friction > 0)) throw InvalidInput("it does not slide");
  std::vector<StoppingError> table;
  for (const Real h : steps) {
    if (!(h > 0)) throw InvalidInput("no step");
    StoppingError row;
    row.step = h;
    for (Real v = speed; v > 0;) {
      v = std::max(0.0, v - friction * kFloorGravity * h);
      row.distance += h * v;
    }
    row.error = row.distance - speed * speed / friction / kFloorGravity / 2;
    table.push_back(row);
  }
  return table;
}

}  // namespace carom
