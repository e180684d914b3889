// Exercise 06.energy_drift: measure how well, and for how long, a method keeps energy.
// Check it with: ./course check 06.energy_drift

#include "energy_drift.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

std::vector<EnergyDrift> energyDrift(StepMethod method, std::span<const Real> lengths, int steps) {
  // Given: what cannot be measured is refused.
  if (steps < 2 || steps % 2 != 0) {
    reject("steps", std::to_string(steps), "must be even and at least two");
  }
  for (const Real dt : lengths) requirePositive(dt, "dt");
  std::vector<EnergyDrift> table;
  // State now = {Coordinates::Ones(1), Coordinates::Zero(1)}; lets the spring go at 1 m, and with
  // Step step = stepOf(method); a step is step(now, time, dt, unitSpring). A column's
  // .squaredNorm() is the sum of its squares.
  return todo<std::vector<EnergyDrift>>("energyDrift");
}

}  // namespace carom
