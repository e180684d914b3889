// Do dice that are thrown come to rest?
//
// The spatial world of this chapter: three dice and a ball are thrown onto a table. Gravity, impulses
// and friction are the functions of the chapter; what touches is chapter 4.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/mass/standard_solids.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"
#include "spatial_world.hpp"

using carom::Real;
using carom::SpatialWorld;
using carom::SpatialWorldBody;
using carom::Vector3;

constexpr Real kHalf = 0.5;        // of a die [m]
constexpr Real kDensity = 1;       // [kg/m^3]
constexpr Real kStep = 1.0 / 240;  // [s]
constexpr int kSteps = 4 * 240;

SpatialWorld thrown() {
  SpatialWorld world;
  SpatialWorldBody table;  // cannot be moved
  table.shape = carom::HalfSpace{Vector3::UnitZ(), 0};
  table.friction = 0.5;
  table.restitution = 0.6;
  world.bodies.push_back(table);

  const Vector3 edges(2 * kHalf, 2 * kHalf, 2 * kHalf);
  const carom::Shape die = carom::makeBox(edges / 2);
  const carom::MassProperties weight = carom::solidBox(edges, kDensity);
  for (const int i : {0, 1, 2}) {
    const Vector3 place(-3.0 + 1.6 * i, 0.3 * i, 2 + 0.9 * i);
    const carom::Velocity motion{{4, 0.5 - 0.6 * i, 0}, {3.0 - i, 5, 2.0 * i}};
    world.bodies.push_back(carom::movableBody(die, weight, place, motion));
  }
  const carom::Shape ball = carom::makeBall(kHalf);
  world.bodies.push_back(carom::movableBody(ball, carom::solidBall(kHalf, kDensity), {-5, 0, 1},
                                            {{5, 0.1, 2}, {0, -12, 0}}));
  for (std::size_t i = 1; i < world.bodies.size(); ++i) {
    world.bodies[i].friction = 0.5;
    world.bodies[i].restitution = 0.7;
  }
  world.bodies[4].rollingArm = 0.01;
  return world;
}

Real energyOf(const SpatialWorldBody& body) {
  const auto& [inverseMass, inverseInertia, R_WB, velocity] = body.motion;
  if (inverseMass == 0) return 0;
  const Vector3 w = R_WB.transpose() * velocity.angular;
  return (velocity.linear.squaredNorm() / inverseMass + w.dot(body.inertia * w)) / 2 +
         9.81 / inverseMass * body.position.z();
}

// The number of a die is that of the face which looks up most; opposite faces add up to seven.
int faceUp(const SpatialWorldBody& die) {
  int number = 0;
  Real best = -1;
  for (int k = 0; k < 3; ++k) {
    const Real up = die.motion.R_WB(2, k);
    if (std::abs(up) > best) best = std::abs(up), number = up > 0 ? k + 1 : 6 - k;
  }
  return number;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  SpatialWorld world = thrown();
  carom::io::Recording recording("Three dice and a ball",
                                 "Three dice and a ball are thrown onto a table; they bounce, hit "
                                 "each other, and come to rest.");
  recording.addFixed("table", carom::io::Plane{20, 1});
  for (const int i : {1, 2, 3}) {
    recording.addBody("die " + std::to_string(i),
                      carom::io::Box{Vector3(2 * kHalf, 2 * kHalf, 2 * kHalf)});
  }
  recording.addBody("ball", carom::io::Ball{kHalf});
  recording.addChannel("energy", "J");

  carom::io::Table table;
  table.column("time [s]", carom::io::fixed(1)).column("energy [J]", carom::io::fixed(3));
  table.column("fastest [m/s]", carom::io::fixed(3))
      .column("lowest corner [mm]", carom::io::fixed(1));
  for (int i = 0; i <= kSteps; ++i) {
    Real energy = 0, fastest = 0, lowest = 1;
    carom::io::Frame frame{.time = i * kStep};
    for (std::size_t k = 1; k < world.bodies.size(); ++k) {
      const SpatialWorldBody& body = world.bodies[k];
      energy += energyOf(body);
      fastest = std::max(fastest, body.motion.velocity.linear.norm());
      const Real reach = k == 4 ? kHalf : kHalf * body.motion.R_WB.row(2).lpNorm<1>();
      lowest = std::min(lowest, body.position.z() - reach);
      frame.poses.push_back({body.position, body.orientation});
    }
    frame.channels = {energy};
    if (i % 4 == 0) recording.addFrame(frame);
    if (i % 120 == 0) table.row({i * kStep, energy, fastest, 1000 * lowest});
    carom::step(world, kStep);
  }
  std::cout << table << "\nThe dice show " << faceUp(world.bodies[1]) << ", "
            << faceUp(world.bodies[2]) << " and " << faceUp(world.bodies[3]) << '\n';
  recording.writeHtml(folder / "dice.html");
}
