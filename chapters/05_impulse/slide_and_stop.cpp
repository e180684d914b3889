// Where does a sliding block stop, and does it then lie still?
//
// A block of 1 kg slides over a table with 4 m/s and friction 0.3. Four rules of friction take the
// same steps of 1/60 s; the exact answer is one line of algebra.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/impulse/friction_impulse.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

constexpr Real kFriction = 0.3;   // [1]
constexpr Real kGravity = 9.81;   // [m/s^2]
constexpr Real kSpeed = 4;        // [m/s]
constexpr Real kStep = 1.0 / 60;  // [s]
constexpr int kSteps = 120;       // 2 s
const Vector3 kUp = Vector3::UnitZ();

struct Block {
  Real x = 0;  // [m]
  Vector3 v{kSpeed, 0, 0};
};

//! [source]
// Equations 35, 36 and 40 with c = 0.3, for 1 kg that does not turn.
Vector3 frictionOfSource(const Vector3& v) {
  const Vector3 a = carom::cross(carom::cross(v, kUp), kUp);
  const Vector3 f = a * v.dot(a);
  const Real j = -(1 + kFriction) * v.dot(f);
  return j * f;
}
//! [source]

// The same with a direction of length one.
Vector3 frictionOfSourceUnit(const Vector3& v) {
  const Real speed = v.norm();
  if (speed == 0) return Vector3::Zero();
  const Vector3 f = v / speed;
  const Real j = -(1 + kFriction) * v.dot(f);
  return j * f;
}

// Coulomb's force while it slides, without asking whether it would stop.
Vector3 frictionUnclamped(const Vector3& v) {
  const Real speed = v.norm();
  if (speed == 0) return Vector3::Zero();
  return -kFriction * kGravity * kStep * v / speed;
}

//! [coulomb]
// The library's: what it takes to stop, but no more than the cone allows.
Vector3 frictionOfCoulomb(const Vector3& v) {
  const Real pressed = kGravity * kStep;  // normal impulse [N s]
  return carom::frictionImpulse(v, kUp, pressed, kFriction, 1);
}
//! [coulomb]

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  struct Rule {
    std::string name;
    Vector3 (*impulse)(const Vector3&);
  };
  const std::vector<Rule> rules = {{"(35), (36), (40) as printed", frictionOfSource},
                                   {"(40), direction of length one", frictionOfSourceUnit},
                                   {"Coulomb's force, unclamped", frictionUnclamped},
                                   {"Coulomb's impulse", frictionOfCoulomb}};
  carom::io::Table table;
  table.column("friction").column("first step [m/s]", carom::io::significant(4));
  table.column("stops at [m]", carom::io::fixed(4))
      .column("at 2 s [m/s]", carom::io::significant(2));
  carom::io::Plot plot("A block that slides to rest");
  plot.xAxis("time [s]").yAxis("speed [m/s]").xRange(1.2, 1.6).yRange(-0.1, 0.4);
  for (const auto& [name, impulse] : rules) {
    Block block;
    Real first = 0;
    std::vector<Real> times{0}, speeds{kSpeed};
    for (int i = 1; i <= kSteps; ++i) {
      block.v += impulse(block.v);
      block.x += kStep * block.v.x();
      if (i == 1) first = block.v.x();
      if (std::abs(block.v.x()) < 4.2) times.push_back(i * kStep), speeds.push_back(block.v.x());
      if (!(std::abs(block.v.x()) < 1e6)) break;  // it has left the table, and the building
    }
    const bool gone = !(std::abs(block.v.x()) < 1e6);
    const bool rests = block.v.x() == 0;
    table.row({name, first, gone ? carom::io::Cell("never") : carom::io::Cell(block.x),
               gone ? carom::io::Cell("-") : carom::io::Cell(rests ? 0.0 : block.v.x())});
    if (name.starts_with("Coulomb")) plot.curve(name, times, speeds, {.marks = true});
  }
  const Real time = kSpeed / (kFriction * kGravity);
  const Real distance = kSpeed * kSpeed / (2 * kFriction * kGravity);
  plot.curve("exact", {0, time, 2}, {kSpeed, 0, 0}, {.dashed = true, .width = 1});
  table.row({"exact", kSpeed - kFriction * kGravity * kStep, distance, 0.0});
  std::cout
      << "A block at 4 m/s, friction 0.3, in steps of 1/60 s for 2 s.\nThe exact block stops after "
      << carom::io::Cell(time).text(carom::io::fixed(4)) << " s\n\n"
      << table;
  plot.writeSvg(folder / "slide_and_stop.svg");
}
