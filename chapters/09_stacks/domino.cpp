// How fast does a row of dominoes fall?
//
// Thirty dominoes, and the first is pushed. In the world, with friction and impacts at their times:
// when does each one begin to turn, and how fast does the wave run? The first one turns about its
// edge, and when it hits the next can be computed beside the world.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/world/world.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;
using carom::world::BodyId;

constexpr int kDominoes = 30;
constexpr Real kStep = 1.0 / 240;
const Vector3 kHalf(0.1, 0.25, 0.5);  // half the edges [m]
constexpr Real kDistance = 0.7;       // from one to the next: a gap of 0.5 m
constexpr Real kPush = 1.2;           // how fast the first one turns at the start [rad/s]

// When the first domino hits the second, if it turns about its lower edge
// and does not slip: a quadrature of dt = d(angle) / speed(angle).
Real firstHit() {
  const Real far = std::sqrt(kHalf.x() * kHalf.x() + kHalf.z() * kHalf.z());
  const Real balance = carom::arctangent2(kHalf.x(), kHalf.z());
  const Real hit = carom::arctangent2(0.5, std::sqrt(0.75));  // sin = gap / height
  const Real k = 9.81 / (4.0 / 3 * far);                      // inertia about the edge: 4/3 m r^2
  const auto slowness = [&](Real angle) {
    const Real fallen = carom::cosine(balance) - carom::cosine(angle - balance);
    return 1 / std::sqrt(kPush * kPush + 2 * k * fallen);
  };
  constexpr int kParts = 1000;
  Real sum = 0;
  for (int i = 0; i < kParts; ++i) sum += slowness((i + 0.5) * hit / kParts) * hit / kParts;
  return sum;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::world::World world({.rowBudget = 4000});
  world.add({.kind = carom::world::BodyKind::immovable,
             .shapes = {{.shape = carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero())}}});
  carom::io::Recording recording("Dominoes", "Thirty dominoes fall, one after the other.");
  recording.addFixed("ground", carom::io::Plane{.size = 26, .gridStep = 1},
                     {{kDistance * kDominoes / 2, 0, 0}});
  std::vector<BodyId> dominoes;
  for (int i = 0; i < kDominoes; ++i) {
    dominoes.push_back(world.add(
        {.position = {i * kDistance, 0, kHalf.z()}, .shapes = {{.shape = carom::makeBox(kHalf)}}}));
    recording.addBody("domino " + std::to_string(i + 1), carom::io::Box{2 * kHalf});
  }
  recording.setView({.direction = {-0.35, 1, -0.35}, .target = Vector3(10, 0, 0), .distance = 17});
  // It turns about its right lower edge.
  world.setVelocity(dominoes[0], {kPush * kHalf.z(), 0, kPush * kHalf.x()}, {0, kPush, 0});

  std::vector<Real> begins(kDominoes, 0), numbers, times;
  for (int n = 0; n < 1920; ++n) {
    if (n % 8 == 0) {
      carom::io::Frame frame{.time = world.time()};
      for (const BodyId id : dominoes) {
        frame.poses.push_back({world.position(id), world.orientation(id)});
      }
      recording.addFrame(frame);
    }
    world.step(kStep);
    for (std::size_t i = 1; i < kDominoes; ++i) {
      const bool turns = world.angularVelocity(dominoes[i]).norm() > 0.05;
      if (turns && begins[i] == 0) begins[i] = world.time();
    }
  }
  carom::io::Table table;
  table.column("domino").column("is hit at [s]", carom::io::fixed(2));
  table.column("speed of the wave [m/s]", carom::io::fixed(2));
  for (const int i : {1, 2, 3, 5, 10, 15, 20, 25, 29}) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Real passed = begins[k] - begins[k - 1];
    table.row({i + 1, begins[k], passed > 0 ? kDistance / passed : 0});
  }
  for (std::size_t i = 1; i < kDominoes; ++i) {
    if (begins[i] == 0) continue;
    numbers.push_back(Real(i + 1));
    times.push_back(begins[i]);
  }
  std::cout << "Dominoes of 1 m, 0.2 m thick, 0.5 m apart\n\n" << table;
  std::cout << "\nThe first hit by energy: "
            << carom::io::Cell(firstHit()).text(carom::io::fixed(4)) << " s\n";
  recording.writeHtml(folder / "domino.html");
  carom::io::Plot plot("When each domino is hit");
  plot.describe(
      "The time of the hit over the number of the domino: after the first few a straight "
      "line.");
  plot.xAxis("domino").yAxis("time [s]").size(700, 380).points("", numbers, times);
  plot.writeSvg(folder / "domino.svg");
}
