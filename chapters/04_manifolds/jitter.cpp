// Why does a box on a floor tremble?
//
// A box of 1 m by 0.4 m rests on a floor, seen from the side. Somebody nudges it, and gravity and
// one simple impulse do the rest. The only difference between the four runs is which points of the
// box are said to touch.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

constexpr Real kHalfWidth = 0.5, kHalfHeight = 0.2;  // [m]
constexpr Real kGravity = 9.81;                      // [m/s^2]
constexpr Real kStep = 1.0 / 120;                    // [s]
constexpr Real kSlop = 0.005;                        // [m]: how deep a resting box may be
constexpr Real kPush = 0.2;                          // part of a deeper overlap undone in a step
constexpr Real kNudge = 0.3;                         // [rad/s]
// Per kilogram: the moment about the centre [m^2].
constexpr Real kMoment = (kHalfWidth * kHalfWidth + kHalfHeight * kHalfHeight) / 3;

struct Box {
  Real y = kHalfHeight - kSlop, angle = 0;  // of the centre [m], [rad]
  Real vy = 0, spin = kNudge;               // [m/s], [rad/s]
};

struct Point {
  Real x = 0;      // arm along the floor, from the centre [m]
  Real depth = 0;  // under the floor [m]
};

Point corner(const Box& box, Real side) {
  const auto [s, c] = carom::sineCosine(box.angle);
  return {side * kHalfWidth * c + kHalfHeight * s,
          -(box.y + side * kHalfWidth * s - kHalfHeight * c)};
}

//! [rules]
// Which points touch?
std::vector<Point> contact(const Box& box, const std::string& rule) {
  const Point left = corner(box, -1), right = corner(box, 1);
  const Point deep = left.depth > right.depth ? left : right;
  const Point high = left.depth > right.depth ? right : left;
  if (deep.depth <= 0) return {};
  if (rule == "on the axis") return {{0, deep.depth}};
  if (rule == "deepest corner") return {deep};
  // Where the lower side of the box comes out of the floor, if it does.
  const Real part = high.depth < 0 ? deep.depth / (deep.depth - high.depth) : 1;
  const Point end{deep.x + part * (high.x - deep.x), std::max(high.depth, 0.0)};
  const Point middle{(deep.x + end.x) / 2, (deep.depth + end.depth) / 2};
  if (rule == "middle of the area") return {middle};
  return {deep, end};
}
//! [rules]

//! [step]
// One step: gravity, then impulses (per kilogram) until no point moves
// into the floor.
void step(Box& box, const std::string& rule) {
  box.vy -= kGravity * kStep;
  const std::vector<Point> points = contact(box, rule);
  std::vector<Real> impulses(points.size(), 0);
  for (int round = 0; round < 20; ++round) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [x, depth] = points[i];
      const Real wanted = kPush * std::max(depth - kSlop, 0.0) / kStep;
      const Real velocity = box.vy + box.spin * x;
      const Real j = (wanted - velocity) / (1 + x * x / kMoment);
      // A floor pushes and never pulls.
      const Real sum = std::max(impulses[i] + j, 0.0);
      box.vy += sum - impulses[i];
      box.spin += x * (sum - impulses[i]) / kMoment;
      impulses[i] = sum;
    }
  }
  box.y += kStep * box.vy;
  box.angle += kStep * box.spin;
}
//! [step]

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Recording recording(
      "A box that somebody has nudged",
      "A flat box on a floor, seen from the side, four times. Held at a point on the axis it turns "
      "and turns; held at one point of the contact it rocks; held at both ends it rests.");
  recording.setView(
      {.flat = true, .up = Vector3::UnitY(), .target = Vector3(0, 0.2, 0), .distance = 0.6});
  recording.setParameter("touching at");
  recording.addFixed("floor", carom::io::Polyline{{{-1.2, 0, 0}, {1.2, 0, 0}}});
  recording.addBody("box", carom::io::Box{Vector3(2 * kHalfWidth, 2 * kHalfHeight, 0.1)});
  recording.addChannel("tilt", "mrad");

  carom::io::Table table;
  table.column("touching at").column("largest tilt [mrad]", carom::io::fixed(2));
  table.column("last second [mrad]", carom::io::fixed(2)).column("it");
  carom::io::Plot plot("A box that somebody has nudged");
  plot.xAxis("time [s]").yAxis("tilt [mrad]").yRange(-25, 25);
  constexpr int kSteps = 480;  // 4 s
  for (const std::string rule :
       {"on the axis", "deepest corner", "middle of the area", "all corners"}) {
    recording.beginCase(rule);
    Box box;
    Real largest = 0, low = 1e9, high = -1e9;
    std::vector<Real> times, tilts;
    for (int i = 0; i <= kSteps; ++i) {
      const Real tilt = 1000 * box.angle;
      const auto [s, c] = carom::sineCosine(box.angle / 2);
      recording.addFrame({i * kStep, {{Vector3(0, box.y, 0), {c, 0, 0, s}}}, {tilt}, {}});
      if (i <= 90 && std::abs(tilt) < 25) times.push_back(i * kStep), tilts.push_back(tilt);
      largest = std::max(largest, std::abs(tilt));
      if (i >= kSteps - 120) low = std::min(low, tilt), high = std::max(high, tilt);
      step(box, rule);
    }
    plot.curve(rule, times, tilts, {.marks = true});
    table.row({rule, largest, high - low,
               high - low < 0.01 ? "rests"
               : largest > 20    ? "turns"
                                 : "rocks"});
  }
  std::cout << table;
  plot.writeSvg(folder / "jitter.svg");
  recording.writeHtml(folder / "jitter.html");
}
