// How fast does a jumper fall?
//
// A jumper of 80 kg leaves an aeroplane that flies at 60 m/s, and opens the parachute after ten
// seconds. The force of the air, as the source has it and as it must be.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/impulse/drag_force.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

constexpr Real kMass = 80;       // [kg]
constexpr Real kGravity = 9.81;  // [m/s^2]
constexpr Real kStep = 1.0 / 240;
const carom::AirDrag kBody{.coefficient = 1.0, .area = 0.7};
const carom::AirDrag kParachute{.coefficient = 1.4, .area = 44};

// Equation 34 as a force along the vertical: a square has no sign, so it
// always points up.
Real dragOfSource(Real v, const carom::AirDrag& air) {
  return air.density * air.coefficient * air.area * v * v / 2;
}

void thrownUp() {
  std::cout << "A ball of 0.1 kg and 0.01 m^2 is thrown up at 20 m/s\n\n";
  carom::io::Table table;
  table.column("drag").column("after 1 s [m/s]", carom::io::fixed(2));
  table.column("highest [m]", carom::io::fixed(2)).column("lands with [m/s]", carom::io::fixed(2));
  const carom::AirDrag air{.coefficient = 0.47, .area = 0.01};
  for (const std::string rule : {"none", "equation 34, upwards", "the library"}) {
    Real z = 0, v = 20, highest = 0, afterSecond = 0;
    int i = 0;
    for (; z >= 0 && i < 10 / kStep; ++i) {
      if (i * kStep == 1) afterSecond = v;
      Real force = 0;
      if (rule == "equation 34, upwards") force = dragOfSource(v, air);
      if (rule == "the library") force = carom::dragForce({0, 0, v}, air).z();
      v += kStep * (force / 0.1 - kGravity);
      z += kStep * v;
      highest = std::max(highest, z);
      if (v > 1000) break;  // out of the atmosphere
    }
    const bool lands = z < 0;
    table.row({rule, afterSecond, lands ? carom::io::Cell(highest) : carom::io::Cell("gone"),
               lands ? carom::io::Cell(-v) : carom::io::Cell("never")});
  }
  std::cout << table;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  thrownUp();

  carom::io::Plot plot("A jump from 1500 m");
  plot.xAxis("time [s]").yAxis("speed of falling [m/s]");
  carom::io::Recording recording("A jump with a parachute",
                                 "A jumper leaves an aeroplane, is carried on by its speed, falls "
                                 "ever faster, opens the parachute and floats down.");
  recording.addBody("jumper", carom::io::Capsule{6, 12}, {.trail = true});
  recording.addFixed("ground", carom::io::Plane{1200, 100});
  recording.addArrow("drag", {}, 0.1);
  recording.addChannel("speed of falling", "m/s");
  recording.setView({.direction = Vector3(0, 1, -0.1)});
  std::vector<Real> times, speeds;
  Vector3 x(-300, 0, 1500), v(60, 0, 0);
  Real fastest = 0, hardest = 0, time = 0;
  for (int i = 0; x.z() > 0; ++i) {
    time = i * kStep;
    // It unfolds within four seconds; at once it would tear.
    const Real open = std::clamp((time - 10) / 4, 0.0, 1.0);
    carom::AirDrag air = open > 0 ? kParachute : kBody;
    air.area = kBody.area + open * open * (kParachute.area - kBody.area);
    const Vector3 drag = carom::dragForce(v, air);
    const Vector3 acceleration = drag / kMass - kGravity * Vector3::UnitZ();
    if (i % 60 == 0) {
      recording.addFrame({time, {{x, {}}}, {-v.z()}, {{x, drag}}});
      times.push_back(time);
      speeds.push_back(-v.z());
    }
    v += kStep * acceleration;
    x += kStep * v;
    fastest = std::max(fastest, -v.z());
    hardest = std::max(hardest, drag.norm() / (kMass * kGravity));
  }
  plot.curve("jumper", times, speeds);
  const auto terminal = [](const carom::AirDrag& air) {
    return std::sqrt(2 * kMass * kGravity / (air.density * air.coefficient * air.area));
  };
  carom::io::Table table;
  table.column("").column("m/s", carom::io::fixed(2));
  table.row({"fastest, falling", fastest})
      .row({"the most that the air allows, without", terminal(kBody)});
  table.row({"speed on the ground", -v.z()})
      .row({"the most that the air allows, with", terminal(kParachute)});
  std::cout << "\nThe jump\n\n"
            << table
            << "\nLargest drag in weights: " << carom::io::Cell(hardest).text(carom::io::fixed(1))
            << "; on the ground after " << carom::io::Cell(time).text(carom::io::fixed(0))
            << " s\n";
  plot.writeSvg(folder / "parachute.svg");
  recording.writeHtml(folder / "parachute.html");
}
