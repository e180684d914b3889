// What does a digit of the forces cost in time?
//
// Two columns of boxes are put down, and one step is made: ten equal ones, and a heavy one on a
// light one. Nothing is known of the forces yet. The world solves them in three ways, each with
// more and more effort. The errors are the same on every machine; the times are of this one.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "carom/world/world.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::World;
using carom::world::WorldSettings;

constexpr Real kStep = 1.0 / 60, kGravity = 9.81;

struct Way {
  std::string name;
  std::vector<WorldSettings> efforts;
};

//! [ways]
std::vector<Way> ways() {
  Way sweeps{"sweeps", {}}, soft{"soft short steps", {}};
  for (const int rows : {100, 1'000, 10'000, 100'000, 1'000'000}) {
    WorldSettings effort;
    effort.directIslands = false;
    effort.iterations = 1;
    effort.rowBudget = rows;
    sweeps.efforts.push_back(effort);
  }
  for (const int parts : {1, 4, 16, 64, 256}) {
    WorldSettings effort;
    effort.pileContacts = effort.pileBodies = 0;
    effort.shortSteps = parts;
    soft.efforts.push_back(effort);
  }
  return {sweeps, soft, {"directly", {WorldSettings()}}};
}
//! [ways]

World columnOf(const std::vector<Real>& masses, const WorldSettings& settings) {
  World world(settings);
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  for (std::size_t i = 0; i < masses.size(); ++i) {
    world.add({.position = Vector3(0, 0, 0.5 + static_cast<Real>(i)),
               .shapes = {{.shape = carom::makeBox({0.5, 0.5, 0.5}), .density = masses[i]}},
               .maySleep = false});
  }
  return world;
}

// The largest error of a contact's force over the weight of the column.
Real errorOf(const World& world, const std::vector<Real>& masses) {
  std::vector<Real> carried(masses.size());
  Real above = 0;
  for (std::size_t i = masses.size(); i-- > 0;) carried[i] = above += kGravity * masses[i];
  Real error = 0;
  std::vector<Real> found;
  for (const auto& pair : world.touching()) found.push_back(pair.normalForce);
  found.resize(masses.size(), 0);
  std::sort(found.rbegin(), found.rend());  // the lowest contact carries most
  for (std::size_t i = 0; i < masses.size(); ++i) {
    error = std::max(error, std::abs(found[i] - carried[i]) / carried[0]);
  }
  return error;
}

// Microseconds of the shortest of a few steps from the same beginning.
Real timeOf(World& world) {
  const auto start = world.save();
  Real least = std::numeric_limits<Real>::infinity();
  for (int n = 0; n < 12; ++n) {
    world.restore(start);
    const auto before = std::chrono::steady_clock::now();
    world.step(kStep);
    const std::chrono::duration<Real, std::micro> took = std::chrono::steady_clock::now() - before;
    least = std::min(least, took.count());
  }
  return least;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<Real> equal(10, 1), unlike = {1, 1000};
  carom::io::Table table;
  table.column("a step from nothing").column("rows visited");
  table.column("ten boxes", carom::io::scientific(1)).column("rows visited");
  table.column("1 under 1000", carom::io::scientific(1));
  carom::io::Plot plot("A column of ten, from nothing, on the machine that made this page");
  plot.describe(
      "Errors of the forces over the time of a step. Sweeps and short steps need more "
      "and more time for a digit; the direct way is one point at rounding.");
  plot.xAxis("time of the step [us]", carom::io::Scale::Logarithmic);
  plot.yAxis("error / weight", carom::io::Scale::Logarithmic);
  for (const Way& way : ways()) {
    std::vector<Real> times, errors;
    for (const WorldSettings& effort : way.efforts) {
      std::vector<carom::io::Cell> cells = {way.name};
      for (const std::vector<Real>* masses : {&equal, &unlike}) {
        World world = columnOf(*masses, effort);
        const Real time = timeOf(world), error = errorOf(world, *masses);
        cells.emplace_back(static_cast<long long>(world.counters().rowsSolved));
        cells.emplace_back(error);
        if (masses != &equal) continue;
        times.push_back(time);
        errors.push_back(std::max(error, 1e-16));
      }
      table.row(cells);
    }
    plot.curve(way.name, times, errors, {.marks = true});
  }
  std::cout << "Largest error of a force, over the weight of the column\n\n" << table;
  plot.writeSvg(folder / "price.svg");
}
