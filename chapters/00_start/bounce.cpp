// How high does a ball come back?
//
// A ball is dropped from 1 m. For each height that it should come back to, restitutionForHeight()
// says how bouncy it must be, and the fall is simulated to see whether it does.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "bounce_back.hpp"
#include "carom_io/number_text.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

namespace {

constexpr Real kGravity = 9.81;    // [m/s²]
constexpr Real kDropHeight = 1;    // [m], of the lowest point of the ball
constexpr Real kRadius = 0.05;     // [m]
constexpr Real kStep = 1.0 / 120;  // [s]
constexpr int kSteps = 300;        // 2.5 s in all
constexpr Real kRestSpeed = 1e-3;  // [m/s]: a slower bounce, 0.05 micrometres high, counts as rest

struct Ball {
  Real height = kDropHeight;  // of the lowest point [m]
  Real velocity = 0;          // upwards [m/s]
  int bounces = 0;
};

//! [advance]
// Moves the ball by a time, exactly: along parabolas, from one contact with the floor to the next.
void advance(Ball& ball, Real time, Real restitution) {
  while (true) {
    // The floor is reached when height + v t - g t²/2 = 0; the later root is the one ahead.
    const Real v = ball.velocity;
    const Real fall = (v + std::sqrt(v * v + 2 * kGravity * ball.height)) / kGravity;
    if (fall >= time) {
      ball.height += (v - kGravity * time / 2) * time;
      ball.velocity -= kGravity * time;
      return;
    }
    ball.height = 0;
    ball.velocity = -restitution * (v - kGravity * fall);
    ball.bounces += 1;
    if (ball.velocity < kRestSpeed) {
      ball.velocity = 0;
      return;
    }
    time -= fall;
  }
}
//! [advance]

bool atRest(const Ball& ball) {
  return ball.bounces > 0 && ball.height == 0 && ball.velocity == 0;
}

carom::io::Pose pose(const Ball& ball) {
  return {Vector3(0, ball.height + kRadius, 0), {}};
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("wanted [m]", carom::io::fixed(2)).column("restitution e", carom::io::fixed(4));
  table.column("came back to [m]", carom::io::fixed(4)).column("bounces in 2.5 s");
  carom::io::Plot plot("A ball dropped from 1 m");
  plot.xAxis("time [s]").yAxis("height [m]");
  carom::io::Recording recording(
      "How high does it come back?",
      "A ball is dropped from 1 m on a floor and bounces, for five coefficients "
      "of restitution.");
  recording.setView({.flat = true, .up = Vector3::UnitY()});
  recording.addFixed("floor", carom::io::Polyline{{Vector3(-0.6, 0, 0), Vector3(0.6, 0, 0)}});
  recording.addBody("ball", carom::io::Disc{kRadius},
                    {.color = carom::io::kVermilion, .trail = true});
  recording.addChannel("height", "m");
  recording.setParameter("wanted height [m]");

  for (Real wanted : {0.0, 0.25, 0.5, 0.8, 1.0}) {
    const Real restitution = carom::restitutionForHeight(kDropHeight, wanted);
    recording.beginCase(carom::io::roundedText(wanted, std::chars_format::fixed, 2));
    Ball ball;
    Real cameBackTo = 0;
    std::vector<Real> times;
    std::vector<Real> heights;
    for (int i = 0; i <= kSteps; ++i) {
      times.push_back(i * kStep);
      heights.push_back(ball.height);
      recording.addFrame({.time = i * kStep, .poses = {pose(ball)}, .channels = {ball.height}});
      if (ball.bounces ==
          1) {  // between the first and the second bounce: how high will it go from here?
        cameBackTo = ball.height + ball.velocity * ball.velocity / (2 * kGravity);
      }
      if (!atRest(ball)) advance(ball, kStep, restitution);
    }
    table.row({wanted, restitution, cameBackTo, ball.bounces});
    plot.curve("back to " + carom::io::roundedText(wanted, std::chars_format::fixed, 2) + " m",
               times, heights);
  }
  std::cout << table;
  plot.writeSvg(folder / "bounce.svg");
  recording.writeHtml(folder / "bounce.html");
}
