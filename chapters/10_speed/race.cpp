// Steps of one length, or steps that fit an error?
//
// A box tips over, a ball slides and rolls, another one bounces: all in one world, and of each it
// is known where it is at the end. First the world takes steps of equal length, the same for all
// three. Then it is told an error, and each of them takes steps of its own. How wrong is each, and
// what did it cost? Rows are counted, so the table is the same on every machine; how long it took
// here stands in a file.

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "known_scenes.hpp"

constexpr Real kTime = 0.45;  // the box has not reached the ground yet [s]

struct Result {
  std::string how;
  long steps = 0;  // of a single island
  long rows = 0;
  std::vector<Real> errors;
  double milliseconds = 0;
};

World threeThings(std::vector<BodyId>& bodies) {
  World world({.sleeping = false});
  addGround(world);
  for (const Known& known : knownScenes()) bodies.push_back(known.add(world));
  return world;
}

// Lets the three go to the end, by whatever does it.
template <class Go>
Result measured(const std::string& how, const Go& go) {
  std::vector<BodyId> bodies;
  World world = threeThings(bodies);
  Result result;
  result.how = how;
  const auto before = std::chrono::steady_clock::now();
  go(world, result);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - before;
  result.milliseconds = took.count();
  const std::vector<Known> scenes = knownScenes();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    result.errors.push_back(scenes[i].error(world, bodies[i], kTime));
  }
  return result;
}

Result bySteps(int rate) {
  return measured("steps of 1/" + std::to_string(rate) + " s", [&](World& world, Result& result) {
    const int count = static_cast<int>(std::lround(kTime * rate));
    for (int k = 0; k < count; ++k) {
      world.step(kTime / count);
      result.rows += rowsOf(world);
      result.steps += static_cast<long>(world.counters().islandsAwake);
    }
  });
}

Result byError(Real tolerance) {
  const std::string asked = carom::io::Cell(tolerance).text(carom::io::scientific(0));
  return measured("error of " + asked, [&](World& world, Result& result) {
    //! [advance]
    world.advance(kTime, tolerance);
    result.rows = rowsOf(world);
    result.steps = static_cast<long>(world.counters().subSteps);
    //! [advance]
  });
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::vector<Result> results;
  for (const int rate : {60, 240, 960, 3840}) results.push_back(bySteps(rate));
  for (const Real tolerance : {1e-3, 1e-6, 1e-9}) results.push_back(byError(tolerance));

  carom::io::Table table;
  table.column("").column("steps").column("rows");
  for (const char* name : {"tips [rad]", "rolls [m]", "bounces [m]"}) {
    table.column(name, carom::io::scientific(0));
  }
  std::ofstream times(folder / "race_times.txt");
  for (const Result& r : results) {
    table.row({r.how, r.steps, r.rows, r.errors[0], r.errors[1], r.errors[2]});
    times << r.how << ": " << r.milliseconds << " ms\n";
  }
  std::cout << "How wrong after 0.45 s\n\n" << table;
}
