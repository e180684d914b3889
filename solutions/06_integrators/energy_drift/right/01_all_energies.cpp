// Keeps all energies, and looks at them afterwards.
#include "energy_drift.hpp"

#include <cmath>
#include <numeric>

#include "carom/core/errors.hpp"

namespace carom {

std::vector<EnergyDrift> energyDrift(StepMethod method, std::span<const Real> lengths, int steps) {
  if (steps < 2 || steps % 2 != 0) throw InvalidInput("an odd number of steps");
  std::vector<EnergyDrift> table;
  for (const Real dt : lengths) {
    if (!(dt > 0) || !std::isfinite(dt)) throw InvalidInput("no step");
    State now = {Coordinates::Constant(1, 1), Coordinates::Constant(1, 0)};
    std::vector<Real> energies;
    for (int i = 0; i < steps; ++i) {
      now = simulate(stepOf(method), now, i * dt, dt, 1, unitSpring);
      const Real x = now.position[0], v = now.velocity[0];
      energies.push_back(x * x + v * v);  // in units of the first one, half a joule
    }
    EnergyDrift row;
    row.dt = dt;
    for (const Real e : energies) row.largest = std::fmax(row.largest, std::abs(e - 1));
    const auto middle = energies.begin() + steps / 2;
    const Real early = std::accumulate(energies.begin(), middle, 0.0);
    const Real late = std::accumulate(middle, energies.end(), 0.0);
    const Real half = steps / 2;
    row.drift = (late / half - early / half) / half / dt;
    table.push_back(row);
  }
  return table;
}

}  // namespace carom
