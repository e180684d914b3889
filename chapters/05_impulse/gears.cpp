// How heavy does a pair of gears feel?
//
// A gear of 10 teeth and 1 kg m^2 drives one of 40 teeth and 16 kg m^2. A torque of 4 N m turns the
// first one for two seconds. In small steps, with an impulse at the teeth after each, and by three
// rules for the inertia that is felt.

#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/impulse/gears.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Gear;
using carom::Real;
using carom::Vector2;
using carom::Vector3;

constexpr int kTeeth1 = 10, kTeeth2 = 40;
constexpr Real kInertia1 = 1, kInertia2 = 16;  // [kg m^2]
constexpr Real kRadius1 = 0.25, kRadius2 = 1;  // [m]
constexpr Real kTorque = 4;                    // [N m]
constexpr Real kTime = 2;                      // [s]
constexpr int kSteps = 240;

std::vector<Vector2> outline(Real radius, int teeth) {
  std::vector<Vector2> corners;
  for (int i = 0; i < 4 * teeth; ++i) {
    const Real r = radius + (i % 4 < 2 ? 0.04 : -0.05);
    const auto [s, c] = carom::sineCosine(2 * std::numbers::pi * (i + 0.5) / (4 * teeth));
    corners.push_back({r * c, r * s});
  }
  return corners;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Recording recording("A small gear drives a large one",
                                 "Two gears that mesh turn in opposite directions, the small one "
                                 "four times as fast.");
  recording.setView(
      {.flat = true, .up = Vector3::UnitY(), .target = Vector3(0.6, 0, 0), .distance = 1.3});
  recording.addBody("10 teeth", carom::io::Polygon{outline(kRadius1, kTeeth1)});
  recording.addBody("40 teeth", carom::io::Polygon{outline(kRadius2, kTeeth2)});
  recording.addChannel("rate of the small one", "rad/s");

  Gear small{kInertia1, kRadius1, 0}, large{kInertia2, kRadius2, 0};
  // Turned by half a tooth, so that teeth stand opposite gaps.
  Real angle1 = 0, angle2 = std::numbers::pi / kTeeth2;
  for (int i = 0; i <= kSteps; ++i) {
    recording.addFrame({i * kTime / kSteps,
                        {{Vector3::Zero(), carom::axisAngleToQuaternion(Vector3::UnitZ(), angle1)},
                         {Vector3(kRadius1 + kRadius2, 0, 0),
                          carom::axisAngleToQuaternion(Vector3::UnitZ(), angle2)}},
                        {small.angularVelocity},
                        {}});
    if (i == kSteps) break;
    small.angularVelocity += kTime / kSteps * kTorque / small.inertia;
    carom::meshGears(small, large);  // the teeth make the rims equal
    angle1 += kTime / kSteps * small.angularVelocity;
    angle2 += kTime / kSteps * large.angularVelocity;
  }
  recording.writeHtml(folder / "gears.html");

  carom::io::Table table;
  table.column("").column("inertia felt [kg m^2]", carom::io::fixed(2));
  table.column("after 2 s [rad/s]", carom::io::fixed(4));
  const auto row = [&table](const char* name, Real inertia) {
    table.row({name, inertia, kTorque * kTime / inertia});
  };
  table.row({"in steps, an impulse at the teeth", kTorque * kTime / small.angularVelocity,
             small.angularVelocity});
  row("I1 + I2 (N1/N2)^2", carom::meshedInertia(kInertia1, kTeeth1, kInertia2, kTeeth2));
  row("sum of both", kInertia1 + kInertia2);
  // The large gear of 32 kg, carried by Steiner to the axle of the small one.
  const Real distance = kRadius1 + kRadius2;
  row("the source: Steiner, and sum", kInertia1 + kInertia2 + 32 * distance * distance);
  std::cout << table;
}
