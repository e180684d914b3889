// Who carries what in a pyramid?
//
// Rows of 5, 4, 3, 2 and 1 boxes of 1 kg, each on two below, in the world. Each box of the lowest row
// stands on the ground; the force there is compared with statics, in which every contact between
// two boxes is in the middle of where they overlap: a quarter point of both, so loads go straight
// down.

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/world/world.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyId;

constexpr int kRows = 5;
constexpr Real kStep = 1.0 / 60;

using Halves = std::array<Real, 2>;  // what is under the left and the right half of a box

struct Box {
  int row = 0, place = 0;
  BodyId id;
  Vector3 start = Vector3::Zero();
};

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::world::World world;
  const BodyId ground =
      world.add({.kind = carom::world::BodyKind::immovable,
                 .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  carom::io::Recording recording("A pyramid", "Fifteen boxes stand in five rows, and do not move.");
  recording.addFixed("ground", carom::io::Plane{.size = 10, .gridStep = 1});
  std::vector<Box> boxes;
  for (int row = 0; row < kRows; ++row) {
    for (int place = 0; place < kRows - row; ++place) {
      const Vector3 start(place - 0.5 * (kRows - 1 - row), 0, row + 0.5);
      const BodyId id =
          world.add({.position = start,
                     .shapes = {{.shape = carom::makeBox({0.5, 0.5, 0.5}), .density = 1}},
                     .maySleep = false});
      boxes.push_back({row, place, id, start});
      recording.addBody(std::to_string(row) + "." + std::to_string(place), carom::io::Box{});
    }
  }
  recording.setView({.direction = {-0.2, 1, -0.25}, .target = Vector3(0, 0, 2), .distance = 11});

  for (int n = 0; n < 600; ++n) {
    if (n % 20 == 0) {
      carom::io::Frame frame{.time = world.time()};
      for (const Box& box : boxes) {
        frame.poses.push_back({world.position(box.id), world.orientation(box.id)});
      }
      recording.addFrame(frame);
    }
    world.step(kStep);
  }

  //! [statics]
  // From the top: what is on half a box goes on below that half, with
  // half of its own weight.
  std::vector<Halves> halves = {{0.5, 0.5}};
  for (int row = kRows - 2; row >= 0; --row) {
    std::vector<Halves> below(halves.size() + 1, {0.5, 0.5});
    for (std::size_t i = 0; i < halves.size(); ++i) {
      below[i][1] += halves[i][0];
      below[i + 1][0] += halves[i][1];
    }
    halves = below;
  }
  //! [statics]
  carom::io::Table table;
  table.column("box of the lowest row").column("statics [N]", carom::io::fixed(3));
  table.column("world [N]", carom::io::fixed(3));
  Real sum = 0;
  for (const Box& box : boxes) {
    if (box.row > 0) continue;
    Real force = 0;
    for (const auto& pair : world.touching()) {
      const bool stands = pair.bodyA == ground || pair.bodyB == ground;
      if (stands && (pair.bodyA == box.id || pair.bodyB == box.id)) force += pair.normalForce;
    }
    sum += force;
    const auto [left, right] = halves[static_cast<std::size_t>(box.place)];
    table.row({box.place + 1, 9.81 * (left + right), force});
  }
  table.row({"all together", 9.81 * 15, sum});
  std::cout << "Who carries what after ten seconds\n\n" << table;
  Real drift = 0;
  for (const Box& box : boxes) {
    drift = std::max(drift, (world.position(box.id) - box.start).norm());
  }
  const bool stands = drift < 1e-6;
  std::cout << "\nNo box has moved by a micrometre: " << (stands ? "true" : "not true") << '\n';
  recording.writeHtml(folder / "pyramid.html");
}
