// Exercise 06.energy_drift: measure how well, and for how long, a method keeps energy.
// Check it with: ./course check 06.energy_drift

#include "energy_drift.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

std::vector<EnergyDrift> energyDrift(StepMethod method, std::span<const Real> lengths, int steps) {
  // Given: what cannot be measured is refused.
  if (steps < 2 || steps % 2 != 0) {
    reject("steps", std::to_string(steps), "must be even and at least two");
  }
  for (const Real dt : lengths) requirePositive(dt, "dt");
  std::vector<EnergyDrift> table;
  const auto energy = [](const State& s) {
    return s.velocity.squaredNorm() / 2 + s.position.squaredNorm() / 2;
  };
  const Step step = stepOf(method);
  const int half = steps / 2;
  for (const Real dt : lengths) {
    State now = {Coordinates::Ones(1), Coordinates::Zero(1)};
    const Real first = energy(now);
    Real largest = 0, early = 0, late = 0;
    for (int i = 0; i < steps; ++i) {
      now = step(now, i * dt, dt, unitSpring);
      const Real error = energy(now) / first - 1;
      largest = std::max(largest, std::abs(error));
      (i < half ? early : late) += error / half;
    }
    table.push_back({dt, largest, (late - early) / half});
  }
  return table;
}

}  // namespace carom
