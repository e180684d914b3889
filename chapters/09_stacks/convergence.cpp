// How many sweeps does a stack need?
//
// A column of boxes that cannot turn, cold: each step begins from nothing. How much of its load has
// the ground felt after so many sweeps? The error shrinks by the same factor in each; that is
// measured and set beside cos^2(pi / 2n). Then the same sweeps from above, and begun warm; and three
// other ways.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/solver/box_column.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "carom/solver/warm_start.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "many_ways.hpp"
#include "sweep_factors.hpp"

using carom::BoxColumn;
using carom::Real;

constexpr Real kSmallest = 1e-12;  // errors below are drawn here: a logarithm has no zero

// n equal boxes of 1 kg that gravity has pulled for a moment.
BoxColumn pulled(int n) {
  BoxColumn column = carom::boxColumn(std::vector<Real>(static_cast<std::size_t>(n), 1));
  carom::pullDown(column.bodies, -1);
  return column;
}

// The largest error of all impulses, as a part of the whole load. The row
// under box i, from below, has to carry the n - i boxes above it.
Real errorOf(const BoxColumn& column) {
  const Real n = static_cast<Real>(column.rows.size());
  Real largest = 0;
  for (const carom::ContactRow& row : column.rows) {
    largest = std::max(largest, std::abs(row.impulse - (n - row.name)) / n);
  }
  return largest;
}

struct History {
  std::vector<Real> sweeps, errors;
};

History errorsOf(BoxColumn column, int sweeps) {
  History history;
  for (int n = 0; n <= sweeps; ++n) {
    history.sweeps.push_back(n);
    history.errors.push_back(std::max(errorOf(column), kSmallest));
    carom::sequentialImpulses(column.bodies, column.rows, 1);
  }
  return history;
}

// How many sweeps bring the error below a bound; at most 20000.
int sweepsFor(BoxColumn column, Real bound) {
  int sweeps = 0;
  while (errorOf(column) > bound && sweeps < 20000) {
    carom::sequentialImpulses(column.bodies, column.rows, 1);
    ++sweeps;
  }
  return sweeps;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";

  const std::vector<int> counts = {2, 5, 10, 20, 40};
  carom::io::Table table;
  table.column("boxes").column("factor", carom::io::fixed(6));
  table.column("cos^2(pi/2n)", carom::io::fixed(6));
  table.column("felt after 10", carom::io::fixed(3)).column("sweeps for 1e-6");
  for (const auto& [boxes, factor] : carom::sweepFactors(counts)) {
    const Real c = carom::cosine(std::numbers::pi / (2 * boxes));
    BoxColumn ten = pulled(boxes);
    carom::sequentialImpulses(ten.bodies, ten.rows, 10);
    table.row({boxes, factor, c * c, ten.rows[0].impulse / boxes, sweepsFor(pulled(boxes), 1e-6)});
  }
  std::cout << "What the ground feels of a tower, cold\n\n" << table << '\n';

  // Ten boxes in other orders, and begun with other numbers.
  BoxColumn fromAbove = pulled(10);
  std::reverse(fromAbove.rows.begin(), fromAbove.rows.end());
  std::vector<carom::KeptImpulse> kept;
  for (const carom::ContactRow& row : fromAbove.rows) kept.push_back({row.name, 10.0 - row.name});
  BoxColumn warm = pulled(10);
  carom::warmStart(warm.bodies, warm.rows, kept, 1);
  carom::io::Table begun;
  begun.column("ten boxes").column("sweeps for 1e-6");
  begun.row({"cold, from below", sweepsFor(pulled(10), 1e-6)});
  begun.row({"cold, from above", sweepsFor(fromAbove, 1e-6)});
  begun.row({"warm", sweepsFor(warm, 1e-6)});
  std::cout << begun << '\n';

  // Forty boxes, and a heavy one on a light one, in four ways.
  constexpr Real kSlow = 1e-6;
  const std::vector<carom::WayResult> tower = carom::manyWays(pulled(40), kSlow);
  BoxColumn unlike = carom::boxColumn(std::vector<Real>{1, 1000});
  carom::pullDown(unlike.bodies, -1);
  const std::vector<carom::WayResult> pair = carom::manyWays(unlike, kSlow);
  carom::io::Table ways;
  ways.column("until at rest").column("40 boxes").column("felt", carom::io::fixed(3));
  ways.column("1000 on 1").column("felt", carom::io::fixed(3));
  carom::io::Plot speeds("Forty boxes in four ways");
  speeds.describe("The speed of the fastest box over passes, on a logarithmic axis.");
  speeds.xAxis("passes").yAxis("speed / fall", carom::io::Scale::Logarithmic);
  speeds.yRange(1e-7, 2).xRange(0, 150).size(760, 440);
  for (std::size_t i = 0; i < tower.size(); ++i) {
    ways.row({tower[i].name, tower[i].passes, tower[i].ground / 40, pair[i].passes,
              pair[i].ground / 1001});
    History history;
    const std::size_t known = tower[i].speeds.size();
    for (std::size_t n = 0; n < std::min<std::size_t>(known, 151); ++n) {
      history.sweeps.push_back(Real(n + 1 < known ? n : std::min(tower[i].passes, 150)));
      history.errors.push_back(std::max(tower[i].speeds[n], kSmallest));
    }
    speeds.curve(tower[i].name, history.sweeps, history.errors);
  }
  std::cout << ways;
  speeds.writeSvg(folder / "ways.svg");

  carom::io::Plot plot("The error of a tower, sweep by sweep");
  plot.describe(
      "Errors of the impulses over sweeps, on a logarithmic axis: straight lines that fall the "
      "less steeply the more boxes there are. Five boxes are done after 150 sweeps, twenty have "
      "hardly begun.");
  plot.xAxis("sweeps").yAxis("largest error / load", carom::io::Scale::Logarithmic);
  plot.yRange(1e-7, 2).size(760, 440);
  for (const int n : counts) {
    const History history = errorsOf(pulled(n), 300);
    plot.curve(std::to_string(n) + " boxes", history.sweeps, history.errors);
  }
  const Real c = carom::cosine(std::numbers::pi / 20);
  std::vector<Real> sweeps, theory;
  for (int n = 0; n <= 300; n += 10) {
    sweeps.push_back(n);
    theory.push_back(std::exp(2 * n * std::log(c)));
  }
  plot.curve("cos^2(pi/20) to the sweeps", sweeps, theory, {.dashed = true});
  plot.writeSvg(folder / "convergence.svg");
}
