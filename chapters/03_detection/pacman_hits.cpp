// Who hits Pac-Man?
//
// Four bodies fly towards him and stop where the detection says that they overlap. Once he is given
// to it as one outline, which is not convex, and once as two convex halves.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/detection/convex_parts.hpp"
#include "carom/detection/sat_polygons.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector2;
using carom::Vector3;
using carom::Verdict;
using Outline = std::vector<Vector2>;
constexpr Real pi = std::numbers::pi;

constexpr Real kMouth = pi / 3;    // [rad]: 60 degrees, open towards +x
constexpr Real kStep = 1.0 / 480;  // [s]: at 1 m/s a body moves 2 mm in it
constexpr int kSteps = 1800;       // 3.75 s

// Points of a circle of 1 m, from one angle to another.
Outline arc(Real from, Real to, int pieces) {
  Outline points;
  for (int i = 0; i <= pieces; ++i) {
    const auto [s, c] = carom::sineCosine(from + (to - from) * i / pieces);
    points.push_back({c, s});
  }
  return points;
}

//! [parts]
std::vector<Outline> asOneOutline() {
  Outline whole = arc(kMouth / 2, 2 * pi - kMouth / 2, 40);
  whole.push_back({0, 0});  // the corner of the mouth
  return {whole};
}

std::vector<Outline> asTwoHalves() {
  Outline upper = arc(kMouth / 2, pi, 20);
  Outline lower = arc(pi, 2 * pi - kMouth / 2, 20);
  upper.push_back({0, 0});
  lower.push_back({0, 0});
  return {upper, lower};
}
//! [parts]

struct Flyer {
  std::string name;
  Outline outline;   // about its own middle [m]
  Vector2 start;     // [m]
  Vector2 velocity;  // [m/s]
};

Outline regular(int corners, Real radius) {
  Outline points = arc(pi / corners, 2 * pi + pi / corners, corners);
  points.pop_back();
  for (Vector2& point : points) point *= radius;
  return points;
}

std::vector<Flyer> flyers() {
  return {{"pellet", regular(24, 0.15), {3.4, 0}, {-1, 0}},
          {"ball", regular(24, 0.3), {2.6, 1.1}, {-1, -0.2}},
          {"triangle", {{-0.35, 0}, {0.2, -0.3}, {0.2, 0.3}}, {2.2, -0.35}, {-0.6, 0.12}},
          {"square", regular(4, 0.3), {1.25, -2.2}, {0, 1}}};
}

Outline moved(const Outline& outline, const Vector2& by) {
  Outline result;
  for (const Vector2& point : outline) result.push_back(point + by);
  return result;
}

// The gap on the best axis, to the nearest part [m].
Real gap(const std::vector<Outline>& parts, const Outline& outline) {
  Real least = std::numeric_limits<Real>::infinity();
  for (const Outline& part : parts) {
    least = std::min(least, carom::satPolygons(part, outline).separation);
  }
  return least;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Recording recording(
      "Who hits Pac-Man?",
      "Four bodies fly towards Pac-Man and stop where they are said to overlap him. As one outline "
      "he "
      "stops a pellet in front of his open mouth; as two halves he lets it in.");
  recording.setView(
      {.flat = true, .up = Vector3::UnitY(), .target = Vector3(0.9, 0, 0), .distance = 2.6});
  recording.setParameter("Pac-Man as");
  recording.addFixed("Pac-Man", carom::io::Polygon{asOneOutline().front()}, {},
                     {.color = carom::io::kYellow});
  for (const Flyer& flyer : flyers()) {
    recording.addBody(flyer.name, carom::io::Polygon{flyer.outline}, {.trail = true});
  }
  recording.addChannel("gap of the pellet", "m");

  carom::io::Table table;
  table.column("Pac-Man as").column("body").column("it").column("at x [m]", carom::io::fixed(2));
  table.column("y [m]", carom::io::fixed(2));
  for (const bool halves : {false, true}) {
    const std::string as = halves ? "two halves" : "one outline";
    const std::vector<Outline> pacman = halves ? asTwoHalves() : asOneOutline();
    recording.beginCase(as);
    std::vector<Vector2> places;
    for (const Flyer& flyer : flyers()) places.push_back(flyer.start);
    std::vector<bool> hit(places.size(), false);
    for (int step = 0; step <= kSteps; ++step) {
      carom::io::Frame frame{.time = step * kStep};
      for (std::size_t i = 0; i < places.size(); ++i) {
        const Flyer flyer = flyers()[i];
        //! [stop]
        const std::vector<Outline> body = {moved(flyer.outline, places[i])};
        if (carom::convexParts(pacman, body) == Verdict::overlapping) hit[i] = true;
        if (!hit[i]) places[i] += kStep * flyer.velocity;
        //! [stop]
        frame.poses.push_back({Vector3(places[i].x(), places[i].y(), 0), {}});
      }
      frame.channels = {gap(pacman, moved(flyers()[0].outline, places[0]))};
      if (step % 8 == 0) recording.addFrame(frame);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      table.row({as, flyers()[i].name, hit[i] ? "hits" : "flies on", places[i].x(), places[i].y()});
    }
  }
  std::cout << table;
  recording.writeHtml(folder / "pacman_hits.html");
}
