// Does it matter who solved a scene, and how many of them?
//
// A large and a small heap of boxes tumble: with one thread and several, with lanes of each width,
// built in the other order, and with a stop half way. Then what would break it: the same numbers
// added up in another order.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/world/world.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::RowWidth;
using carom::Vector3;
using carom::world::BodyId;
using carom::world::World;
using carom::world::WorldSettings;

constexpr Real kStep = 1.0 / 60;
constexpr int kSteps = 30;

// Boxes of a metre in layers, each layer shifted against the one below, all with some speed.
void addHeap(World& world, int side, int layers, Real x) {
  carom::Random random(side);
  for (int layer = 0; layer < layers; ++layer) {
    const Real shift = layer % 2 == 0 ? 0 : 0.3;
    for (int i = 0; i < side * side; ++i) {
      const Vector3 at(x + 1.1 * (i % side) + shift, 1.1 * (i / side) + shift,
                       0.505 + 1.005 * layer);
      world.add({.position = at,
                 .velocity = random.vector(),
                 .angularVelocity = random.vector(),
                 .shapes = {{.shape = carom::makeBox({0.5, 0.5, 0.5})}}});
    }
  }
}

struct Scene {
  WorldSettings settings = {};
  bool otherOrder = false, stop = false;
};

std::uint64_t hashOf(const Scene& scene) {
  World world(scene.settings);
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  if (scene.otherOrder) addHeap(world, 3, 2, 100);
  addHeap(world, 8, 5, 0);
  if (!scene.otherOrder) addHeap(world, 3, 2, 100);
  for (int n = 0; n < kSteps; ++n) {
    if (scene.stop && n == kSteps / 2) {
      const auto kept = world.save();
      world.step(0.3 * kStep);  // something that shall be forgotten
      world.restore(kept);
    }
    world.step(kStep);
  }
  return world.hash();
}

std::string hex(std::uint64_t number) {
  std::array<char, 17> text = {};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(number));
  return text.data();
}

//! [sums]
// 1 + 1/2 + 1/3 + ... by `lanes` sums side by side.
float harmonic(int count, int lanes) {
  std::vector<float> sums(static_cast<std::size_t>(lanes), 0);
  for (int k = 0; k < count; ++k) {
    const float term = 1 / static_cast<float>(k + 1);
    sums[static_cast<std::size_t>(k % lanes)] += term;
  }
  float sum = 0;
  for (const float part : sums) sum += part;
  return sum;
}
//! [sums]

int main() {
  std::vector<std::pair<std::string, Scene>> scenes = {{"one thread", {}}};
  for (const int threads : {2, 3, 5}) {
    scenes.push_back({std::to_string(threads) + " threads", {.settings = {.threads = threads}}});
  }
  scenes.push_back({"four lanes", {.settings = {.rowWidth = RowWidth::narrow}}});
  scenes.push_back({"one lane", {.settings = {.rowWidth = RowWidth::plain}}});
  scenes.push_back({"the small heap first", {.otherOrder = true}});
  scenes.push_back({"saved and restored half way", {.stop = true}});
  carom::io::Table table;
  table.column("338 boxes, 30 steps").column("hash of the end");
  for (const auto& [name, scene] : scenes) table.row({name, hex(hashOf(scene))});
  std::cout << table;

  carom::io::Table sums;
  sums.column("sum of 1/k to a million, in floats").column("", carom::io::fixed(5));
  for (const int lanes : {1, 4, 8}) {
    sums.row({std::to_string(lanes) + (lanes == 1 ? " sum" : " sums"), harmonic(1'000'000, lanes)});
  }
  std::cout << '\n' << sums;
}
