// Does a tower of ten boxes stand?
//
// Four towers, one method each, all with this chapter's functions: ten sweeps that begin from
// nothing in every step; the same begun warm; sub-steps with soft contacts; and, to compare, the
// world. The first three are columns that cannot tip over: what can be seen is how far they sink.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "carom/solver/box_column.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "carom/solver/substep.hpp"
#include "carom/solver/warm_start.hpp"
#include "carom/world/world.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::BoxColumn;
using carom::Real;
using carom::Vector3;
using carom::Velocity;

constexpr int kBoxes = 10;
constexpr int kSweeps = 10;
constexpr Real kStep = 1.0 / 60;
constexpr Real kGravity = 9.81;

// A column, how far its boxes have moved, and what the rows gave last.
struct Tower {
  std::string name;
  std::function<void(Tower&)> step;
  BoxColumn column = carom::boxColumn(std::vector<Real>(kBoxes, 1));
  std::vector<Velocity> moved = std::vector<Velocity>(kBoxes + 1);
};

//! [sweeps]
// A step with sweeps. A part of each overlap is taken away in it, by
// asking for speed (Baumgarte); a gap may be closed. Try a fifth.
void stepWithSweeps(Tower& tower, bool warm) {
  auto& [bodies, rows] = tower.column;
  carom::pullDown(bodies, -kGravity * kStep);
  std::vector<carom::KeptImpulse> kept;
  for (carom::ContactRow& row : rows) {
    if (warm) kept.push_back({row.name, row.impulse});
    const Real steps = row.separation < 0 ? 20 : 1;
    row.target = -row.separation / (steps * kStep);
  }
  carom::warmStart(bodies, rows, kept, 1);
  carom::sequentialImpulses(bodies, rows, kSweeps);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    tower.moved[i].linear += kStep * bodies[i].velocity.linear;
  }
  for (carom::ContactRow& row : rows) {
    row.separation += kStep * carom::partingSpeed(row, bodies);
  }
}
//! [sweeps]

// Ten sub-steps have ten soft sweeps and ten rigid ones.
void stepInParts(Tower& tower) {
  auto& [bodies, rows] = tower.column;
  const carom::SoftContact soft = carom::softContact(60, 5, kStep / kSweeps);
  const carom::SubstepPlan plan{
      .gravity = {0, 0, -kGravity}, .dt = kStep, .count = kSweeps, .soft = soft};
  carom::substep(bodies, rows, tower.moved, plan);
}

Real heightOf(const Tower& tower, int box) {
  return box - 0.5 + tower.moved[static_cast<std::size_t>(box)].linear.z();
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::vector<Tower> towers = {{"10 sweeps, cold", [](Tower& t) { stepWithSweeps(t, false); }},
                               {"10 sweeps, warm", [](Tower& t) { stepWithSweeps(t, true); }},
                               {"10 soft sub-steps", stepInParts}};

  carom::world::World world;
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  std::vector<carom::world::BodyId> boxes;
  for (int i = 1; i <= kBoxes; ++i) {
    boxes.push_back(world.add({.position = {4.5, 0, i - 0.5},
                               .shapes = {{.shape = carom::makeBox({0.5, 0.5, 0.5})}},
                               .maySleep = false}));
  }

  carom::io::Recording recording("Four towers",
                                 "From the left: cold sweeps, warm sweeps, soft sub-steps, world.");
  recording.addFixed("ground", carom::io::Plane{.size = 14, .gridStep = 1});
  for (const char* name : {"cold", "warm", "soft", "world"}) {
    for (int i = 1; i <= kBoxes; ++i) {
      recording.addBody(std::string(name) + " " + std::to_string(i), carom::io::Box{},
                        {.color = i % 2 == 0 ? carom::io::kVermilion : carom::io::kBlue});
    }
  }
  recording.setView({.direction = {0, 1, -0.1}, .target = Vector3(0, 0, 4.5), .distance = 24});

  for (int n = 0; n <= 600; ++n) {
    if (n % 6 == 0) {
      carom::io::Frame frame{.time = world.time()};
      for (std::size_t k = 0; k < towers.size(); ++k) {
        for (int i = 1; i <= kBoxes; ++i) {
          frame.poses.push_back({{-4.5 + 3 * Real(k), 0, heightOf(towers[k], i)}});
        }
      }
      for (const auto& box : boxes) frame.poses.push_back({world.position(box)});
      recording.addFrame(frame);
    }
    for (Tower& tower : towers) tower.step(tower);
    world.step(kStep);
  }

  carom::io::Table table;
  table.column("after 10 s").column("top has sunk [mm]", carom::io::fixed(3));
  table.column("deepest overlap [mm]", carom::io::fixed(3));
  for (const Tower& tower : towers) {
    Real deepest = 0;
    for (const carom::ContactRow& row : tower.column.rows) {
      deepest = std::max(deepest, -row.separation);
    }
    table.row({tower.name, 1000 * (kBoxes - 0.5 - heightOf(tower, kBoxes)), 1000 * deepest});
  }
  Real deepest = 0;
  for (const auto& pair : world.touching()) deepest = std::max(deepest, -pair.separation);
  const Real sunk = kBoxes - 0.5 - world.position(boxes.back()).z();
  table.row({"the world", 1000 * sunk, 1000 * deepest});
  std::cout << "A tower of ten boxes of 1 m\n\n" << table;
  recording.writeHtml(folder / "tower.html");
}
