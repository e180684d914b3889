// Does a block slide as far to the north-east as to the east?
//
// A block of 1 kg slides over a level floor at 2 m/s, in all directions of the compass. Its contact
// is solved by the sweeps of this chapter, with friction within the cone; and, beside it, with each
// of the two directions limited by itself.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/solver/box_column.hpp"
#include "carom/solver/friction_pyramid_to_cone.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector2;

constexpr Real kStep = 1.0 / 240;
constexpr Real kFriction = 0.5;
constexpr Real kSpeed = 2;  // [m/s]
constexpr Real kDegree = std::numbers::pi / 180;

// Each direction limited by itself.
Vector2 pyramid(const Vector2& friction, const Vector2& slip, Real mass, Real limit) {
  const auto within = [&](Real f) { return std::clamp(f, -limit, limit); };
  return {within(friction.x() - mass * slip.x()), within(friction.y() - mass * slip.y())};
}

// Where the block comes to rest, having started at the origin.
template <class Friction>
Vector2 slide(Real degrees, Friction frictionOf) {
  carom::BoxColumn scene = carom::boxColumn(std::vector<Real>{1});
  carom::MovingBody& block = scene.bodies[1];
  block.velocity.linear = {kSpeed * carom::cosine(degrees * kDegree),
                           kSpeed * carom::sine(degrees * kDegree), 0};
  Vector2 at = Vector2::Zero();
  for (int n = 0; n < 400; ++n) {
    carom::pullDown(scene.bodies, -9.81 * kStep);
    scene.rows[0].impulse = 0;
    Vector2 friction = Vector2::Zero();
    for (int sweep = 0; sweep < 4; ++sweep) {
      //! [visit]
      carom::sequentialImpulses(scene.bodies, scene.rows, 1);
      const Real limit = kFriction * scene.rows[0].impulse;
      const Vector2 slip = block.velocity.linear.head<2>();
      const Vector2 sum = frictionOf(friction, slip, 1.0, limit);
      block.velocity.linear.head<2>() += sum - friction;
      friction = sum;
      //! [visit]
    }
    at += kStep * block.velocity.linear.head<2>();
  }
  return at;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("towards [deg]").column("cone [m]", carom::io::fixed(3));
  table.column("off [deg]", carom::io::fixed(1)).column("pyramid [m]", carom::io::fixed(3));
  table.column("off [deg]", carom::io::fixed(1));
  std::vector<Real> coneX, coneY, pyramidX, pyramidY;
  for (int degrees = 0; degrees <= 360; degrees += 3) {
    const Vector2 cone = slide(degrees, carom::frictionPyramidToCone);
    const Vector2 other = slide(degrees, pyramid);
    coneX.push_back(cone.x());
    coneY.push_back(cone.y());
    pyramidX.push_back(other.x());
    pyramidY.push_back(other.y());
    if (degrees > 90 || degrees % 15 != 0) continue;
    const auto off = [&](const Vector2& p) {
      return carom::arctangent2(p.y(), p.x()) / kDegree - degrees;
    };
    table.row({degrees, cone.norm(), off(cone), other.norm(), off(other)});
  }
  std::cout << "Where a block comes to rest that starts at 2 m/s\n\n" << table;

  carom::io::Plot plot("Where a block comes to rest");
  plot.describe(
      "A circle for the cone; for the pyramid a curve within it that is pulled in along "
      "the diagonals and touches it on the axes.");
  plot.xAxis("x [m]").yAxis("y [m]").equalAspect().size(520, 520);
  plot.curve("cone", coneX, coneY).curve("pyramid", pyramidX, pyramidY);
  plot.writeSvg(folder / "cone_or_pyramid.svg");
}
