// What does a step leave out, and does anybody notice?
//
// One scene with something for each idea: towers that rest, walls that never move, balls and a
// spinning plate in flight, a fast ball. It is run with all ideas, and then with one of them
// switched off at a time. Side by side: what was counted in two seconds, and how far the bodies end
// from where they ended before.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/world/world.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyDescription;
using carom::world::BodyId;
using carom::world::BodyKind;
using carom::world::Counters;
using carom::world::Material;
using carom::world::PairFinding;
using carom::world::World;
using carom::world::WorldSettings;

BodyId add(World& world, BodyKind kind, const carom::Shape& shape, const Vector3& at,
           const Vector3& velocity = Vector3::Zero(), const Vector3& spin = Vector3::Zero(),
           const Material& material = {}) {
  BodyDescription body;
  body.kind = kind;
  body.position = at;
  body.velocity = velocity;
  body.angularVelocity = spin;
  body.shapes = {{.shape = shape, .material = material}};
  return world.add(body);
}

// Twenty towers of two, two hundred walls, fifteen balls and a plate in flight, a fast ball.
void build(World& world) {
  add(world, BodyKind::immovable, carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero()),
      Vector3::Zero());
  for (int i = 0; i < 200; ++i) {
    const Vector3 at(-40.0 - 2 * (i % 20), 3.0 * (i / 20), 1);
    add(world, BodyKind::immovable, carom::makeBox({0.1, 1, 1}), at);
  }
  for (int i = 0; i < 40; ++i) {
    const Vector3 at(2.0 * (i % 20), 0, 0.5 + i / 20);
    add(world, BodyKind::dynamic, carom::makeBox(Vector3::Constant(0.5)), at);
  }
  carom::Random random(808);
  for (int i = 0; i < 15; ++i) {
    const Vector3 velocity = random.vector(2), spin = random.vector(9);
    add(world, BodyKind::dynamic, carom::makeBall(0.3), {3.0 * i, 20, 30}, velocity, spin);
  }
  add(world, BodyKind::dynamic, carom::makeBox({0.6, 0.3, 0.05}), {0, 40, 30}, Vector3::Zero(),
      {0.1, 9, 0.2});
  add(world, BodyKind::dynamic, carom::makeBall(0.2), {-32.5, 9, 1}, {-300, 0, 0}, Vector3::Zero(),
      {.friction = 0, .restitution = 1});
}

struct Run {
  Counters sum;
  std::vector<Vector3> ends;
  std::uint64_t hash = 0;
};

Run runWith(const WorldSettings& settings) {
  World world(settings);
  build(world);
  Run run;
  for (int n = 0; n < 121; ++n) {
    world.step(1.0 / 60);
    if (n == 0) continue;  // all pairs are new
    const Counters& now = world.counters();
    for (const auto what :
         {&Counters::bodiesAwake, &Counters::bodiesAsleep, &Counters::pairsAwake,
          &Counters::manifoldsMade, &Counters::axesSearches, &Counters::normalRows,
          &Counters::frictionRows, &Counters::rowsSolved, &Counters::firstContacts,
          &Counters::impacts, &Counters::exactRotations}) {
      run.sum.*what += now.*what;
    }
  }
  for (const BodyId body : world.bodies()) run.ends.push_back(world.position(body));
  run.hash = world.hash();
  return run;
}

Real farthest(const Run& a, const Run& b) {
  Real most = 0;
  for (std::size_t i = 0; i < a.ends.size(); ++i) {
    most = std::max(most, (a.ends[i] - b.ends[i]).norm());
  }
  return most;
}

int main() {
  //! [switches]
  WorldSettings all, everyPair, awake, blind, kicked, smooth;
  everyPair.pairFinding = PairFinding::allPairs;
  awake.sleeping = false;
  blind.continuous = false;
  kicked.exactRotation = false;
  smooth.friction = false;
  //! [switches]
  const std::vector<std::string> names = {"all on",   "all pairs", "no sleep",
                                          "no times", "no closed", "no rub"};
  std::vector<Run> runs;
  for (const WorldSettings& settings : {all, everyPair, awake, blind, kicked, smooth}) {
    runs.push_back(runWith(settings));
  }

  carom::io::Table table;
  table.column("");
  for (const std::string& name : names) table.column(name);
  const auto tell = [&](const char* what, std::int64_t Counters::*counter) {
    std::vector<carom::io::Cell> cells = {what};
    for (const Run& run : runs) cells.emplace_back(static_cast<long>(run.sum.*counter));
    table.row(cells);
  };
  tell("stepped", &Counters::bodiesAwake);
  tell("skipped", &Counters::bodiesAsleep);
  tell("pairs", &Counters::pairsAwake);
  tell("manifolds", &Counters::manifoldsMade);
  tell("by axes", &Counters::axesSearches);
  tell("rows", &Counters::normalRows);
  tell("of friction", &Counters::frictionRows);
  tell("swept", &Counters::rowsSolved);
  tell("first times", &Counters::firstContacts);
  tell("impacts", &Counters::impacts);
  tell("spins", &Counters::exactRotations);
  std::vector<carom::io::Cell> bits = {"same bits"}, ways = {"apart"};
  for (const Run& run : runs) {
    bits.emplace_back(run.hash == runs[0].hash ? "yes" : "no");
    const Real way = farthest(run, runs[0]);
    ways.emplace_back(way == 0 ? "0" : way < 1e-9 ? "< 1 nm" : way < 1000 ? "< 1 km" : "> 1 km");
  }
  table.row(bits).row(ways);
  std::cout << "What 120 steps did, with all ideas and without one\n\n" << table;
}
