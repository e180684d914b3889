// What moves, what turns, and when does it touch?
//
// Eight pairs whose first contact is known: straight lines, parabolas, bodies that turn, one that
// grazes. First by closed form, where there is one, then by the general search; and the steps that
// it needs for each digit, beside those of the plain bound by the fastest corner.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/rotation/integrate_orientation.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/swept_ball_plane.hpp"
#include "carom/toi/swept_balls.hpp"
#include "carom/toi/toi_rotating.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Shape;
using carom::Sweep;
using carom::TimeOfImpact;
using carom::Vector3;

const Vector3 kGravity(0, 0, -9.81);  // [m/s^2]

carom::Pose turned(const Vector3& axisAngle, const Vector3& place) {
  return carom::poseOf(carom::integrateOrientation({1, 0, 0, 0}, axisAngle, 1), place);
}

struct Pair {
  std::string name;
  Shape a;
  Sweep A;
  Shape b;
  Sweep B;
  Real exact;  // first contact [s]
};

Sweep at(const Vector3& place) {
  return {.start = {carom::Matrix3::Identity(), place}};
}

//! [box]
Sweep tumblingBox() {
  Sweep box = at({0, 0, 1.4});
  box.velocity = {0, 0, -2};
  box.acceleration = kGravity;
  box.angularVelocity = 4 * Vector3(1, 2, 2) / 3;
  return box;
}
//! [box]

// A blade of 1 m that turns by 48 degrees in a step.
Sweep blade() {
  Sweep s;
  s.start = turned({0, std::numbers::pi / 2, 0}, {0.5, 0, 0});
  s.centre = {0, 0, -0.5};
  s.angularVelocity = {0, 0, 50};
  return s;
}

// The tip of an arm of half a metre that turns at 20 rad/s while it sinks.
Sweep spinningTip(Real height) {
  Sweep s;
  s.centre = {-0.5, 0, 0};
  s.start = turned({0, 0.1, 0}, Vector3::Zero());
  s.start.p_WB = Vector3(0, 0, height) - s.start.R_WB * s.centre;
  s.velocity = {0, 0, -0.3};
  s.angularVelocity = {0, 20, 0};
  return s;
}

std::vector<Pair> zoo() {
  Sweep ball = at({10, 1, 2}), thrown = at({0, 0, 10}), rod;
  ball.velocity = {-7, -0.5, -1};
  thrown.velocity = {5, 1, 3};
  thrown.acceleration = kGravity;
  rod.start = turned({0, std::numbers::pi / 2 + 0.2, 0}, {0, 0, 1.2});
  rod.angularVelocity = {0, 6, 0};
  rod.acceleration = kGravity;
  const carom::HalfSpace floor, low = {Vector3::UnitZ(), -0.125}, lower = {Vector3::UnitZ(), -0.25};
  return {
      {"two balls", carom::Ball{1}, {}, carom::Ball{0.5}, ball, 1.250808145456967783},
      {"a thrown ball", carom::Ball{0.5}, thrown, floor, {}, 1.730703089568409052},
      {"a falling rod", carom::Capsule{0.125, 1}, rod, low, {}, 0.206326853983603236},
      {"a tumbling box",
       carom::Box{{0.5, 0.3, 0.2}},
       tumblingBox(),
       floor,
       {},
       0.263628806083517999},
      {"the same, on a box", carom::Box{{0.5, 0.3, 0.2}}, tumblingBox(), carom::Box{{9, 9, 1}},
       at({0, 0, -1}), 0.263628806083517999},
      {"a blade", carom::Capsule{0.025, 0.5}, blade(), carom::Ball{0.025}, at({0.6, 0.6, 0}),
       0.014528768889269560},
      {"the tip of an arm", carom::Ball{0.25}, spinningTip(0.8), lower, {}, 1.010422862066883642},
      {"one that grazes",
       carom::Ball{0.25},
       spinningTip(0.522286961781481531 - 1e-12),
       lower,
       {},
       0.075039941408407014},
  };
}

// Steps that each search needs for a gap of so much, for two boxes.
void draw(const std::filesystem::path& file) {
  const carom::ConvexHull box = carom::boxHull({0.5, 0.3, 0.2}), slab = carom::boxHull({9, 9, 1});
  std::vector<Real> gaps, plain, second;
  for (int k = 1; k <= 12; ++k) {
    const Real gap = std::pow(10.0, -k);
    gaps.push_back(gap);
    plain.push_back(
        toiRotating(box.vertices, tumblingBox(), slab.vertices, at({0, 0, -1}), 1, gap).steps);
    second.push_back(
        firstContact(box, tumblingBox(), slab, at({0, 0, -1}), 1, {.tolerance = gap}).steps);
  }
  carom::io::Plot plot("A box that tumbles onto another");
  plot.xAxis("gap that counts as contact [m]", carom::io::Scale::Logarithmic).yAxis("steps");
  plot.describe("The plain search needs more steps for each digit, the other one hardly any.");
  plot.curve("fastest corner", gaps, plain, {.marks = true});
  plot.curve("second order", gaps, second, {.marks = true});
  plot.writeSvg(file);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("pair").column("first contact [s]", carom::io::fixed(9));
  table.column("off by [s]", carom::io::scientific(0)).column("gap [m]", carom::io::scientific(0));
  table.column("steps");
  const TimeOfImpact balls = carom::sweptBalls({.radius = 1}, {0.5, {10, 1, 2}, {-7, -0.5, -1}}, 5);
  table.row({"two balls, closed form", balls.time, balls.time - zoo()[0].exact, balls.gap, ""});
  const TimeOfImpact landed =
      carom::sweptBallPlane({0.5, {0, 0, 10}, {5, 1, 3}}, kGravity, carom::HalfSpace{}, 5);
  table.row({"a thrown ball, the same", landed.time, landed.time - zoo()[1].exact, landed.gap, ""});
  for (const Pair& p : zoo()) {
    const TimeOfImpact hit = firstContact(p.a, p.A, p.b, p.B, 5);
    table.row({p.name, hit.time, hit.time - p.exact, hit.gap, hit.steps});
  }
  std::cout << table;
  draw(folder / "toi_zoo.svg");

  carom::io::Recording recording("A tumbling box", "It stops where it touches the floor first.");
  recording.addBody("box", carom::io::Box{Vector3(1, 0.6, 0.4)}, {.axes = true});
  recording.addBody("contact", carom::io::Ball{0.04});
  recording.addFixed("floor", carom::io::Plane{4, 0.5});
  const TimeOfImpact hit =
      firstContact(carom::Box{{0.5, 0.3, 0.2}}, tumblingBox(), carom::HalfSpace{}, {}, 1);
  for (int i = 0; i <= 80; ++i) {
    const Real t = std::min(hit.time * i / 60, hit.time);
    const carom::Quaternion turn =
        carom::integrateOrientation({1, 0, 0, 0}, tumblingBox().angularVelocity, t);
    const Vector3 place = poseAt(tumblingBox(), t).p_WB;
    const Vector3 mark = i < 60 ? place : hit.point;  // inside the box until then
    recording.addFrame({.time = i / 20.0, .poses = {{place, turn}, {mark}}});
  }
  recording.writeHtml(folder / "toi_zoo.html");
}
