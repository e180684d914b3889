// What happens on a billiard table?
//
// The planar world of this chapter: discs without friction on a table with four cushions. First one
// oblique hit, beside the formula; then the break of fifteen balls, with balls that lose nothing
// and with balls that lose a little.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"
#include "planar_world.hpp"

using carom::PlanarWorld;
using carom::PlanarWorldBody;
using carom::Real;
using carom::Vector2;
using carom::Vector3;

constexpr Real kRadius = 0.02625;                // [m]
constexpr Real kMass = 0.17;                     // [kg]
constexpr Real kLength = 2.24, kWidth = 1.12;    // of the table [m]
const Real kRowStep = std::sqrt(3.0) * kRadius;  // between the rows of the triangle [m]

PlanarWorldBody ball(const Vector2& position, const Vector2& velocity, Real e) {
  PlanarWorldBody body;
  body.shape = carom::Disc{kRadius};
  body.motion = {carom::planarBodyMass(kMass, kMass * kRadius * kRadius / 2), {velocity, 0}};
  body.position = position;
  body.restitution = e;
  return body;
}

Real energy(const PlanarWorld& world) {
  Real sum = 0;
  for (const PlanarWorldBody& body : world.bodies) {
    sum += kMass * body.motion.velocity.linear.squaredNorm() / 2;
  }
  return sum;
}

// One ball hits another, 0.7 of a diameter beside its middle.
void oblique() {
  std::cout << "A ball at 1 m/s hits another, 0.7 diameters off the line of centres\n\n";
  PlanarWorld world;
  world.bodies = {ball({0, 0.7 * 2 * kRadius}, {1, 0}, 1), ball({0.5, 0}, {0, 0}, 1)};
  carom::step(world, 1);
  const Vector2 cue = world.bodies[0].motion.velocity.linear;
  const Vector2 other = world.bodies[1].motion.velocity.linear;
  carom::io::Table table;
  table.column("").column("world", carom::io::fixed(12)).column("formula", carom::io::fixed(12));
  // sin(phi) = 0.7; the target leaves along the line of centres.
  table.row({"speed of the target [m/s]", other.norm(), std::sqrt(1 - 0.49)});
  table.row({"speed of the cue ball [m/s]", cue.norm(), 0.7});
  table.row({"cosine of the angle between", cue.dot(other) / cue.norm() / other.norm(), 0.0});
  std::cout << table;
}

// Fifteen balls in a triangle, touching, and the cue ball.
PlanarWorld rack(Real e) {
  PlanarWorld world;
  world.bodies.push_back(ball({0.56, kWidth / 2}, {6, 0.02}, e));
  for (int row = 0; row < 5; ++row) {
    for (int i = 0; i <= row; ++i) {
      const Vector2 place(1.68 + row * kRowStep, kWidth / 2 + (2 * i - row) * kRadius);
      world.bodies.push_back(ball(place, {0, 0}, e));
    }
  }
  world.walls = {
      {{1, 0}, 0, 1, 0}, {{-1, 0}, -kLength, 1, 0}, {{0, 1}, 0, 1, 0}, {{0, -1}, -kWidth, 1, 0}};
  return world;
}

void record(carom::io::Recording& recording, carom::io::Table& table, const std::string& name,
            Real e) {
  recording.beginCase(name);
  PlanarWorld world = rack(e);
  const Real before = energy(world);
  for (int frame = 0; frame <= 240; ++frame) {
    carom::io::Frame moment{.time = world.time};
    for (const PlanarWorldBody& body : world.bodies) {
      moment.poses.push_back({Vector3(body.position.x(), body.position.y(), 0),
                              carom::axisAngleToQuaternion(Vector3::UnitZ(), body.angle)});
    }
    moment.channels = {energy(world)};
    recording.addFrame(moment);
    carom::step(world, 1.0 / 60);
  }
  table.row({name, world.impacts, before, energy(world)});
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  oblique();

  carom::io::Recording recording(
      "The break",
      "A cue ball runs into a triangle of fifteen balls, seen from above. They fly "
      "apart and bounce off the cushions.");
  recording.setView({.flat = true,
                     .up = Vector3::UnitY(),
                     .target = Vector3(kLength / 2, kWidth / 2, 0),
                     .distance = 0.75});
  recording.setParameter("balls");
  recording.addFixed(
      "cushions",
      carom::io::Polyline{
          {{0, 0, 0}, {kLength, 0, 0}, {kLength, kWidth, 0}, {0, kWidth, 0}, {0, 0, 0}}});
  for (int i = 0; i < 16; ++i) {
    recording.addBody(i == 0 ? "cue ball" : "ball " + std::to_string(i), carom::io::Disc{kRadius});
  }
  recording.addChannel("energy", "J");
  carom::io::Table table;
  table.column("the break").column("impacts").column("energy [J]", carom::io::fixed(12));
  table.column("after 4 s", carom::io::fixed(12));
  record(recording, table, "e = 1", 1);
  record(recording, table, "e = 0.96", 0.96);
  std::cout << '\n' << table;
  recording.writeHtml(folder / "billiards.html");
}
