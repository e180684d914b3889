// What comes of the last bit of one number?
//
// 27 balls fly in a room and bounce without loss. In a second room everything is the same, but one
// ball starts by the last bit of a number further to the right. Both are drawn side by side.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/world/world.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyId;
using carom::world::World;

constexpr int kBalls = 27;
constexpr Real kStep = 1.0 / 60, kHalf = 1.5, kRadius = 0.2;  // of the room, and of a ball [m]

struct Room {
  World world{{.gravity = Vector3::Zero()}};
  std::vector<BodyId> balls;
};

Room roomOf(Real toTheRight) {
  Room room;
  for (int i = 0; i < 6; ++i) {
    const Vector3 in = (i < 3 ? 1 : -1) * Vector3::Unit(i % 3);
    const carom::Shape wall = carom::makeHalfSpace(in, -kHalf * in);
    room.world.add({.kind = carom::world::BodyKind::immovable,
                    .shapes = {{.shape = wall, .material = {0, 1}}}});
  }
  const carom::Shape ball = carom::makeBall(kRadius);
  carom::Random random(27);
  for (int i = 0; i < kBalls; ++i) {
    Vector3 at(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i == 0) at.x() += toTheRight;
    const Vector3 speed = 3 * random.direction();
    room.balls.push_back(room.world.add(
        {.position = at, .velocity = speed, .shapes = {{.shape = ball, .material = {0, 1}}}}));
  }
  return room;
}

std::vector<Vector3> placesOf(const Room& room) {
  std::vector<Vector3> places;
  for (const BodyId ball : room.balls) places.push_back(room.world.position(ball));
  return places;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  Room one = roomOf(0), other = roomOf(0x1p-53);
  carom::io::Recording recording(
      "The last bit",
      "Balls fly about in two rooms side by side, in both alike. After seven seconds they begin "
      "to fly differently, and soon no ball is where its twin is.");
  const Vector3 aside(1.2 * kHalf, 0, 0);
  for (const Real side : {-1.0, 1.0}) {
    recording.addFixed(side < 0 ? "room" : "twin", carom::io::Box{Vector3::Constant(2 * kHalf)},
                       {.position = side * aside},
                       {.color = carom::io::Color{120, 120, 120}, .wireframe = true});
  }
  recording.addSwarm("as it is", {.count = kBalls, .radius = kRadius, .color = carom::io::kBlue});
  recording.addSwarm("by the last bit",
                     {.count = kBalls, .radius = kRadius, .color = carom::io::kPalette[1]});
  recording.addChannel("furthest apart, power of ten", "");
  recording.setView({.direction = {-0.1, 1, -0.3}, .target = Vector3::Zero(), .distance = 10});

  carom::io::Table table;
  table.column("27 balls, one of them 1e-16 m to the right");
  table.column("furthest apart [m]", carom::io::scientific(0));
  for (int n = 0; n <= 600; ++n) {
    const std::vector<Vector3> p = placesOf(one), q = placesOf(other);
    Real furthest = 0;
    for (std::size_t i = 0; i < p.size(); ++i) furthest = std::max(furthest, (p[i] - q[i]).norm());
    if (n % 3 == 0) {
      std::vector<Vector3> left = p, right = q;
      for (Vector3& ball : left) ball -= aside;
      for (Vector3& ball : right) ball += aside;
      recording.addFrame({.time = n * kStep,
                          .channels = {std::log10(std::max(furthest, 1e-17))},
                          .swarms = {left, right}});
    }
    if (n == 60 || (n > 0 && n % 120 == 0)) {
      table.row({"after " + std::to_string(n / 60) + " s", furthest});
    }
    one.world.step(kStep);
    other.world.step(kStep);
  }
  std::cout << table;
  recording.writeHtml(folder / "twins.html");
}
