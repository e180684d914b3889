// When are short steps needed?
//
// A comet on an orbit of eccentricity 0.99 spends years far from the sun and hours near it. Equal
// steps must be as short as the hours ask; a method that chooses its steps saves them for there.
// Both go round once, and the place at the end is the place at the start.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/motion/rk4.hpp"
#include "carom/motion/rk_adaptive.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/trajectory.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Coordinates;
using carom::Real;
using carom::State;

const Real kEccentricity = 0.99;
const Real kYear = 2 * std::numbers::pi;

State farthestFromTheSun() {
  const Real e = kEccentricity;
  return {Coordinates{{-1 - e, 0.0}}, Coordinates{{0.0, -std::sqrt((1 - e) / (1 + e))}}};
}

// The same, but counts how often it is asked, and when.
struct Gravity {
  std::vector<Real>* times;

  Coordinates operator()(Real t, const Coordinates& x, const Coordinates&) const {
    times->push_back(t);
    const Real r = x.norm();
    return -x / (r * r * r);
  }
};

struct Row {
  std::string name;
  State end;
  std::size_t forces;
};

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const State start = farthestFromTheSun();
  std::vector<Row> rows;

  for (int n : {1000, 10000, 100000}) {
    std::vector<Real> times;
    const State end = carom::simulate(carom::rk4, start, 0, kYear / n, n, Gravity{&times});
    rows.push_back({"order 4, equal steps", end, times.size()});
  }
  //! [adaptive]
  for (Real digits : {1e-6, 1e-9, 1e-12}) {
    std::vector<Real> times;
    const carom::Tolerance allowed{.relative = digits, .absolute = digits};
    const Gravity gravity{&times};
    const auto run = rkAdaptive(start, 0, kYear, allowed, gravity);
    rows.push_back({"order 5, chosen steps", run.state, times.size()});
  }
  //! [adaptive]
  for (Real tolerance : {1e-6, 1e-9, 1e-12}) {
    std::vector<Real> times;
    const carom::Trajectory path(start, 0, kYear, Gravity{&times},
                                 {.relative = tolerance, .absolute = tolerance});
    rows.push_back({"order 8, chosen steps", path.run().state, times.size()});
  }

  std::cout << "Once round the sun, eccentricity 0.99\n\n";
  carom::io::Table table;
  table.column("method").column("forces asked for");
  table.column("off by, at the end", carom::io::scientific(1));
  for (const Row& row : rows) {
    table.row({row.name, row.forces, (row.end.position - start.position).norm()});
  }
  std::cout << table;

  // A step asks seven times, first at its start. One that is thrown away is tried again from there.
  std::vector<Real> times;
  carom::rkAdaptive(start, 0, kYear, {.relative = 1e-9, .absolute = 1e-9}, Gravity{&times});
  std::vector<Real> when, length;
  for (std::size_t i = 0; i + 7 < times.size(); i += 7) {
    if (times[i + 7] == times[i]) continue;
    when.push_back(times[i] / kYear);
    length.push_back((times[i + 7] - times[i]) / kYear);
  }
  carom::io::Plot plot("Steps of a comet");
  plot.xAxis("time [years]").yAxis("length of the step [years]", carom::io::Scale::Logarithmic);
  plot.describe(
      "The steps are a hundredth of a year away from the sun, and fall steeply to less "
      "than a ten thousandth in the middle of the year.");
  plot.curve("", when, length, {.marks = true, .width = 1});
  plot.writeSvg(folder / "comet.svg");
}
