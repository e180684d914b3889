// Which methods keep the energy of a spring?
//
// A spring of 1 kg and 1 N/m is let go at 1 m and makes a million steps by three methods; explicit
// Euler makes a thousand, for it would leave the doubles. The largest error says how far its energy
// is ever off, the drift where it goes on the whole. A drift of less than a
// billionth is a swing that the end of the run has cut off.

#include <iostream>
#include <string>
#include <vector>

#include "carom_io/table.hpp"
#include "energy_drift.hpp"

using carom::Real;
using carom::StepMethod;

struct Run {
  std::string name;
  StepMethod method;
  int steps;
};

int main() {
  const std::vector<Run> runs = {{"explicit Euler", StepMethod::kExplicitEuler, 1000},
                                 {"semi-implicit Euler", StepMethod::kSemiImplicitEuler, 1000000},
                                 {"velocity Verlet", StepMethod::kVelocityVerlet, 1000000},
                                 {"Runge and Kutta's", StepMethod::kRk4, 1000000}};
  carom::io::Table table;
  table.column("method").column("steps").column("of [s]", carom::io::fixed(1));
  table.column("largest error [1]", carom::io::scientific(1));
  table.column("drift [1/s]", carom::io::scientific(1));
  for (const Run& run : runs) {
    const std::vector<Real> lengths = {0.2, 0.1};
    for (const carom::EnergyDrift& row : carom::energyDrift(run.method, lengths, run.steps)) {
      table.row({run.name, run.steps, row.dt, row.largest, row.drift});
    }
  }
  std::cout << "The energy of a spring\n\n" << table;
}
