// Does a top spin for ever?
//
// The source says so of its friction: at a single point nothing slips. A disc of 0.1 m lies on a
// table and spins with 50 rad/s, once touching at a point and once with its whole face.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/impulse/friction_impulse.hpp"
#include "carom/impulse/point_velocity.hpp"
#include "carom/impulse/spinning_friction.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

constexpr Real kRadius = 0.1, kMass = 1, kFriction = 0.25, kGravity = 9.81;
constexpr Real kInertia = kMass * kRadius * kRadius / 2;  // [kg m^2]
constexpr Real kStart = 50;                               // [rad/s]
constexpr Real kStep = 1.0 / 60;                          // [s]
constexpr int kSteps = 150;

// One contact point, on the axis: it does not move, so there is no slip,
// and no friction.
Real spinAfterPoint(Real spin) {
  const carom::Velocity motion{Vector3::Zero(), spin * Vector3::UnitZ()};
  const Vector3 arm = Vector3::Zero();
  const Vector3 slip = carom::pointVelocity(motion, arm);
  const Vector3 impulse =
      carom::frictionImpulse(slip, Vector3::UnitZ(), kMass * kGravity * kStep, kFriction, kMass);
  return spin + (arm.x() * impulse.y() - arm.y() * impulse.x()) / kInertia;
}

// A face that presses evenly: 2/3 mu N R.
Real spinAfterPatch(Real spin) {
  const Real pressed = kMass * kGravity * kStep;  // [N s]
  return spin + carom::spinningFriction({spin, kInertia, pressed, kFriction, kRadius}) / kInertia;
}

//! [rings]
// The same torque by hand: many rings, each with its share of the weight.
Real torqueOfRings(int rings) {
  Real torque = 0;
  for (int i = 0; i < rings; ++i) {
    const Real r = kRadius * (i + 0.5) / rings;
    const Real share = 2 * (i + 0.5) / rings / rings;
    torque += kFriction * share * kMass * kGravity * r;
  }
  return torque;
}
//! [rings]

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::cout << "The torque of friction under a disc, summed over rings [N m]\n\n";
  carom::io::Table sums;
  sums.column("rings").column("torque", carom::io::fixed(8));
  for (const int rings : {1, 10, 100, 1000}) sums.row({rings, torqueOfRings(rings)});
  sums.row({"2/3 mu N R", 2 * kFriction * kMass * kGravity * kRadius / 3});
  std::cout << sums << '\n';

  carom::io::Recording recording("A disc that spins on a table",
                                 "A striped disc spins about its axis. Touching at one point it "
                                 "spins for ever; touching with its face it stops after 1.5 s.");
  recording.setParameter("touching with");
  recording.addFixed("table", carom::io::Plane{0.8, 0.1});
  recording.addBody("disc", carom::io::Cylinder{kRadius, 0.03});
  recording.addBody("mark on the disc", carom::io::Box{Vector3(2 * kRadius, 0.02, 0.032)});
  recording.addChannel("spin", "rad/s");
  carom::io::Plot plot("A disc that spins on the spot");
  plot.xAxis("time [s]").yAxis("spin [rad/s]").yRange(0, 60);
  carom::io::Table table;
  table.column("touching with").column("stops after [s]", carom::io::fixed(3));
  table.column("turns", carom::io::fixed(3)).column("spin at the end [rad/s]", carom::io::fixed(1));
  for (const bool patch : {false, true}) {
    const std::string name = patch ? "its face" : "one point";
    recording.beginCase(name);
    Real spin = kStart, angle = 0, stops = -1;
    std::vector<Real> times, spins;
    for (int i = 0; i <= kSteps; ++i) {
      const carom::io::Pose pose{Vector3(0, 0, 0.016),
                                 carom::axisAngleToQuaternion(Vector3::UnitZ(), angle)};
      recording.addFrame({i * kStep, {pose, pose}, {spin}, {}});
      times.push_back(i * kStep);
      spins.push_back(spin);
      if (spin == 0 && stops < 0) stops = i * kStep;
      const Real before = spin;
      spin = patch ? spinAfterPatch(spin) : spinAfterPoint(spin);
      angle += kStep * (before + spin) / 2;
    }
    plot.curve(name, times, spins);
    table.row({name, stops < 0 ? carom::io::Cell("never") : carom::io::Cell(stops),
               angle / 6.283185307179586, spin});
  }
  const Real time = 3 * kRadius * kStart / (4 * kFriction * kGravity);
  table.row({"exact, face", time, kStart * time / 2 / 6.283185307179586, 0.0});
  std::cout << table;
  plot.writeSvg(folder / "spinning_top.svg");
  recording.writeHtml(folder / "spinning_top.html");
}
