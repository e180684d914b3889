// What if the heavy one stands on the light one?
//
// A box of 1 kg with one of M kg on it. The exact impulses come from trying everything; sweeps come
// nearer by M / (M + 1) each. Then both as real boxes, in the world.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/solver/active_rows.hpp"
#include "carom/solver/box_column.hpp"
#include "carom/solver/lcp_small.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "carom/world/world.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::BoxColumn;
using carom::Real;
using carom::Vector3;

constexpr Real kStep = 1.0 / 60;
constexpr Real kGravity = 9.81;

// How far the heavy box of the world has sunk after ten seconds [m].
Real sunkInTheWorld(Real heavy) {
  carom::world::World world;
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  carom::world::BodyId top;
  for (int i = 0; i < 2; ++i) {
    top = world.add(
        {.position = {0, 0, 0.5 + i},
         .shapes = {{.shape = carom::makeBox({0.5, 0.5, 0.5}), .density = i == 0 ? 1 : heavy}},
         .maySleep = false});
  }
  for (int n = 0; n < 600; ++n) world.step(kStep);
  return 1.5 - world.position(top).z();
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("M [kg]", carom::io::significant(7)).column("exact [N]", carom::io::fixed(2));
  table.column("20 sweeps [N]", carom::io::fixed(2)).column("factor", carom::io::fixed(6));
  table.column("M/(M+1)", carom::io::fixed(6)).column("world [mm]", carom::io::fixed(3));
  carom::io::Plot plot("A heavy box on a light one");
  plot.describe(
      "The error over sweeps for masses of 1, 10, 100 and 1000 kg: the heavier the upper "
      "box, the flatter the line. At 1000 kg it cannot be seen to fall.");
  plot.xAxis("sweeps").yAxis("error / load", carom::io::Scale::Logarithmic);
  plot.yRange(1e-6, 2).size(760, 420);
  for (const Real heavy : {1.0, 10.0, 100.0, 1000.0, 1e6}) {
    //! [judge]
    BoxColumn column = carom::boxColumn(std::vector<Real>{1, heavy});
    auto& [bodies, rows] = column;
    carom::pullDown(bodies, -kGravity * kStep);
    const auto [A, b] = carom::rowProblem(bodies, rows);
    const std::vector<Real> exact = carom::lcpSmall(A, b);
    //! [judge]
    std::vector<Real> sweeps, errors;
    Real factor = 0, felt = 0;
    for (int n = 0; n <= 100; ++n) {
      const Real error = (exact[0] - rows[0].impulse) / exact[0];
      if (n == 5) factor = error / errors.back();
      if (n == 20) felt = rows[0].impulse / kStep;
      sweeps.push_back(n);
      errors.push_back(std::max(std::abs(error), 1e-12));
      carom::sequentialImpulses(bodies, rows, 1);
    }
    if (heavy < 1e6) plot.curve("M = " + std::to_string(int(heavy)) + " kg", sweeps, errors);
    table.row(
        {heavy, exact[0] / kStep, felt, factor, heavy / (heavy + 1), 1000 * sunkInTheWorld(heavy)});
  }
  std::cout << "A box of 1 kg on the ground, one of M kg on it\n\n" << table;
  plot.writeSvg(folder / "mass_ratio.svg");
}
