// How does Pac-Man fly when he is hit on the head?
//
// He consists of two convex halves (chapter 3), but he is one body: one mass, one centre, one moment
// of inertia. A blow of 1 N s to the right hits him at his top. Four ways to reckon, and the right
// one is the first.

#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/impulse/planar_motion.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::PlanarVelocity;
using carom::Real;
using carom::Vector2;
using carom::Vector3;
constexpr Real pi = std::numbers::pi;

constexpr Real kHalfAngle = 5 * pi / 12;  // of one half: it spans 150 degrees
const Vector2 kTop(0, 1);                 // where he is hit, from the middle of the disc [m]
const Vector2 kBlow(1, 0);                // [N s]

struct Part {
  Real mass = 0;                     // [kg], at 1 kg/m^2
  Vector2 center = Vector2::Zero();  // of mass, from the middle of the disc [m]
  Real inertia = 0;                  // about its centre of mass [kg m^2]
};

// A sector of a disc of 1 m, its middle at an angle. About the middle of the disc a sector has the
// inertia m/2, like the whole disc.
Part half(Real angle) {
  const Real mass = kHalfAngle;
  const Real distance = 2 * carom::sineCosine(kHalfAngle).sine / (3 * kHalfAngle);
  const auto [s, c] = carom::sineCosine(angle);
  return {mass, distance * Vector2(c, s), mass / 2 - mass * distance * distance};
}

//! [compound]
// One body of two halves: Steiner carries each to the common centre.
Part together(const Part& p, const Part& q) {
  Part whole;
  whole.mass = p.mass + q.mass;
  whole.center = (p.mass * p.center + q.mass * q.center) / whole.mass;
  for (const Part& part : {p, q}) {
    const Vector2 arm = part.center - whole.center;
    whole.inertia += part.inertia + part.mass * arm.squaredNorm();
  }
  return whole;
}
//! [compound]

PlanarVelocity hit(const Part& body, const Vector2& arm) {
  return {kBlow / body.mass, carom::planarCross(arm, kBlow) / body.inertia};
}

std::vector<Vector2> outline() {
  std::vector<Vector2> corners = {Vector2::Zero()};
  for (int i = -50; i <= 50; ++i) {
    const auto [s, c] = carom::sineCosine(2 * kHalfAngle * i / 50);
    corners.push_back({c, s});
  }
  return corners;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const Part upper = half(kHalfAngle), lower = half(-kHalfAngle);
  const Part whole = together(upper, lower);
  Part noSteiner = whole;
  noSteiner.inertia = upper.inertia + lower.inertia;

  struct Way {
    std::string name;
    PlanarVelocity after;
    Vector2 center;  // about which he then turns [m]
  };
  const std::vector<Way> ways = {
      {"one body", hit(whole, kTop - whole.center), whole.center},
      {"arm from the half's middle", hit(whole, kTop - upper.center), whole.center},
      {"moments without Steiner", hit(noSteiner, kTop - whole.center), whole.center},
      {"the upper half alone", hit(upper, kTop - upper.center), upper.center}};

  carom::io::Recording recording("Pac-Man is hit on the head",
                                 "Pac-Man flies to the right and turns clockwise after a blow at "
                                 "his top. Reckoned wrongly he turns too slowly or too fast.");
  recording.setView(
      {.flat = true, .up = Vector3::UnitY(), .target = Vector3(2, 0, 0), .distance = 2.2});
  recording.setParameter("reckoned as");
  recording.addBody("Pac-Man", carom::io::Polygon{outline()}, {.color = carom::io::kYellow});
  recording.addChannel("turned by", "rad");

  carom::io::Table table;
  table.column("reckoned as").column("mass [kg]", carom::io::fixed(3));
  table.column("speed [m/s]", carom::io::fixed(4)).column("spin [rad/s]", carom::io::fixed(4));
  table.column("L [N m s]", carom::io::fixed(4));
  for (const auto& [name, after, center] : ways) {
    // About the true centre of mass, of what moves: it must be that of the blow.
    const Real mass = name == "the upper half alone" ? upper.mass : whole.mass;
    const Real inertia = name == "the upper half alone" ? upper.inertia : whole.inertia;
    const Vector2 arm = center - whole.center;
    const Real angularMomentum =
        inertia * after.angular + carom::planarCross(arm, mass * after.linear);
    table.row({name, mass, after.linear.x(), after.angular, angularMomentum});
    recording.beginCase(name);
    for (int i = 0; i <= 240; ++i) {
      const Real t = i / 30.0;
      const auto [s, c] = carom::sineCosine(after.angular * t);
      const Vector2 arm_W(c * center.x() - s * center.y(), s * center.x() + c * center.y());
      const Vector2 middle = center + t * after.linear - arm_W;
      recording.addFrame({t,
                          {{Vector3(middle.x(), middle.y(), 0),
                            carom::axisAngleToQuaternion(Vector3::UnitZ(), after.angular * t)}},
                          {after.angular * t},
                          {}});
    }
  }
  std::cout
      << "A blow of 1 N s to the right. About the centre of mass its\nangular momentum L is "
      << carom::io::Cell(carom::planarCross(kTop - whole.center, kBlow)).text(carom::io::fixed(4))
      << " N m s\n\n"
      << table;
  recording.writeHtml(folder / "pacman_spin.html");
}
