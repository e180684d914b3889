// How many steps does a search take that never steps past a contact?
//
// First a gap of 1 m that closes at 1 m/s, with bounds on its speed that are better and worse. Then
// a blade of 1 m that turns about its end at 50 rad/s towards a point: the bound is that of its
// tip, so its caution is the blade's length over the point's distance from the axis.

#include <cmath>
#include <iostream>
#include <vector>

#include "advance_cost.hpp"
#include "carom/toi/toi_rotating.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

//! [blade]
carom::TimeOfImpact bladeHits(Real distance, Real tolerance) {
  carom::Sweep blade, point;
  blade.start.p_WB = {0.5, 0, 0};
  blade.centre = {-0.5, 0, 0};
  blade.angularVelocity = {0, 0, 50};
  point.start.p_WB = distance / std::sqrt(2) * Vector3(1, 1, 0);
  const std::vector<Vector3> ends = {{-0.5, 0, 0}, {0.5, 0, 0}};
  const std::vector<Vector3> one = {{0, 0, 0}};
  return toiRotating(ends, blade, one, point, 1.0 / 60, tolerance);
}
//! [blade]

int main() {
  const std::vector<Real> tolerances = {1e-3, 1e-6, 1e-9};
  carom::io::Table table;
  table.column("bound / speed", carom::io::fixed(2));
  table.column("1e-3 m").column("1e-6 m").column("1e-9 m");
  for (const Real caution : {1.0, 1.1, 2.0, 4.0, 10.0, 100.0}) {
    const std::vector<carom::AdvanceCost> cost = carom::advanceCost(caution, tolerances);
    table.row({caution, cost[0].steps, cost[1].steps, cost[2].steps});
  }
  std::cout << "A gap of 1 m, steps until it is as small as\n\n" << table;

  carom::io::Table blade;
  blade.column("distance [m]", carom::io::fixed(2)).column("hit at [s]", carom::io::fixed(6));
  blade.column("1e-3 m").column("1e-6 m").column("1e-9 m");
  for (const Real distance : {0.95, 0.5, 0.25}) {
    std::vector<int> steps;
    for (const Real tolerance : tolerances) steps.push_back(bladeHits(distance, tolerance).steps);
    blade.row({distance, bladeHits(distance, 1e-9).time, steps[0], steps[1], steps[2]});
  }
  std::cout << "\nA blade turns by 45 degrees to a point\n\n" << blade;
}
