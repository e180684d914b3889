// What do sweeps alone need, and what does a direct solution?
//
// Five scenes at rest that begin from nothing, each in two worlds for two seconds: one that only
// sweeps, and one that solves an island directly where sweeps gain little. Counted are the rows
// that were visited, and the matrices that were taken apart.

#include <algorithm>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "carom/world/world.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyId;
using carom::world::World;

constexpr Real kStep = 1.0 / 60;

struct Boxes {
  World& world;
  std::vector<BodyId> ids;
  std::vector<Vector3> starts;

  void add(const Vector3& place, Real mass) {
    starts.push_back(place);
    ids.push_back(
        world.add({.position = place,
                   .shapes = {{.shape = carom::makeBox({0.5, 0.5, 0.5}), .density = mass}},
                   .maySleep = false}));
  }
};

void addTower(Boxes& boxes, int count, Real oddMass) {
  for (int i = 0; i < count; ++i) boxes.add({0, 0, i + 0.5}, i % 2 == 0 ? 1 : oddMass);
}

void addPyramid(Boxes& boxes) {
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i < 5 - row; ++i) boxes.add({i - 0.5 * (4 - row), 0, row + 0.5}, 1);
  }
}

struct Needed {
  Real rows = 0, factorisations = 0;  // in all steps
  Real moved = 0;                     // the box that moved most [m]
};

Needed needed(const std::function<void(Boxes&)>& build, bool direct) {
  World world({.directIslands = direct});
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  Boxes boxes{world, {}, {}};
  build(boxes);
  Needed needed;
  for (int n = 0; n < 120; ++n) {
    world.step(kStep);
    needed.rows += Real(world.counters().rowsSolved);
    needed.factorisations += Real(world.counters().factorisations);
  }
  for (std::size_t i = 0; i < boxes.ids.size(); ++i) {
    needed.moved = std::max(needed.moved, (world.position(boxes.ids[i]) - boxes.starts[i]).norm());
  }
  return needed;
}

int main() {
  struct Scene {
    std::string name;
    std::function<void(Boxes&)> build;
  };
  const std::vector<Scene> scenes = {
      {"tower of 10", [](Boxes& boxes) { addTower(boxes, 10, 1); }},
      {"tower of 40", [](Boxes& boxes) { addTower(boxes, 40, 1); }},
      {"1000 kg on 1 kg", [](Boxes& boxes) { addTower(boxes, 2, 1000); }},
      {"1, 100, 1, ... kg", [](Boxes& boxes) { addTower(boxes, 10, 100); }},
      {"pyramid of 15", addPyramid}};
  carom::io::Table table;
  table.column("scene").column("swept", carom::io::fixed(0));
  table.column("moved [mm]", carom::io::fixed(3)).column("direct", carom::io::fixed(0));
  table.column("factored", carom::io::fixed(0)).column("moved [mm]", carom::io::fixed(3));
  for (const Scene& scene : scenes) {
    const Needed swept = needed(scene.build, false), direct = needed(scene.build, true);
    table.row({scene.name, swept.rows, 1000 * swept.moved, direct.rows, direct.factorisations,
               1000 * direct.moved});
  }
  std::cout << "Rows visited in two seconds: by sweeps alone, and solved directly\n\n" << table;
}
