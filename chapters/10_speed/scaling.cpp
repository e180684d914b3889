// How does the work of a step grow with the number of bodies?
//
// Heaps of boxes, from some hundreds to some thousands, settle. What a step does is
// counted, and the counts are the same on every machine; how long it takes on this one is drawn.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <vector>

#include "carom/world/world.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::World;

constexpr Real kStep = 1.0 / 60;
constexpr int kSettling = 40, kMeasured = 20, kLayers = 5;

// Boxes of a metre in layers, each layer shifted by a quarter against the one below.
World heapOf(int side) {
  World world;
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  for (int layer = 0; layer < kLayers; ++layer) {
    const Real shift = layer % 2 == 0 ? 0 : 0.25;
    for (int i = 0; i < side * side; ++i) {
      const Vector3 at(1.02 * (i % side) + shift, 1.02 * (i / side) + shift, 1.001 * layer + 0.5);
      world.add({.position = at,
                 .shapes = {{.shape = carom::makeBox({0.5, 0.5, 0.5}), .density = 1}},
                 .maySleep = false});
    }
  }
  for (int n = 0; n < kSettling; ++n) world.step(kStep);
  return world;
}

// Seconds of the shortest of a few steps: what else the machine does comes on top.
Real shortestStep(World& world) {
  Real least = std::numeric_limits<Real>::infinity();
  for (int n = 0; n < kMeasured; ++n) {
    const auto before = std::chrono::steady_clock::now();
    world.step(kStep);
    const std::chrono::duration<Real> took = std::chrono::steady_clock::now() - before;
    least = std::min(least, took.count());
  }
  return least;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("boxes").column("contacts").column("colours");
  table.column("contacts / box", carom::io::fixed(2));
  table.column("rows / box", carom::io::fixed(0));
  std::vector<Real> counts, times[2];
  for (const int side : {8, 11, 16, 20}) {
    const Real boxes = kLayers * side * side;
    World world = heapOf(side);
    const carom::world::Counters did = world.counters();
    const auto perBox = [&](std::int64_t count) { return static_cast<Real>(count) / boxes; };
    table.row({static_cast<int>(boxes), did.pileContacts, did.pileColors, perBox(did.pileContacts),
               perBox(did.rowsSolved)});
    counts.push_back(boxes);
    for (const int threads : {1, 2}) {
      world.change({.threads = threads});
      times[threads - 1].push_back(1e3 * shortestStep(world));
    }
  }
  std::cout << "Heaps of boxes that have settled: one step\n\n" << table;
  carom::io::Plot plot("A step, on the machine that made this page");
  plot.describe(
      "Time of a step over the number of boxes, for one and two threads: straight lines "
      "of slope one, the second below the first.");
  plot.xAxis("boxes", carom::io::Scale::Logarithmic);
  plot.yAxis("shortest step [ms]", carom::io::Scale::Logarithmic);
  plot.curve("one thread", counts, times[0], {.marks = true});
  plot.curve("two threads", counts, times[1], {.marks = true});
  plot.slope("slope 1", 1, counts[0], times[0][0]);
  plot.writeSvg(folder / "scaling.svg");

  // The same heap with more and fewer short steps in a step: what each costs, and all the rest.
  std::vector<Real> shortSteps, milliseconds;
  World world = heapOf(16);
  for (const int count : {2, 4, 8, 12, 16}) {
    world.change({.shortSteps = count});
    shortSteps.push_back(count);
    milliseconds.push_back(1e3 * shortestStep(world));
  }
  carom::io::Plot parts("1,280 boxes, on the machine that made this page");
  parts.describe(
      "Time of a step over the number of short steps in it: a line that rises evenly, "
      "and meets the axis well above zero.");
  parts.xAxis("short steps").xRange(0, 17).yAxis("shortest step [ms]");
  parts.yRange(0, 1.15 * *std::max_element(milliseconds.begin(), milliseconds.end()));
  parts.curve("one thread", shortSteps, milliseconds, {.marks = true});
  parts.writeSvg(folder / "short_steps.svg");
}
