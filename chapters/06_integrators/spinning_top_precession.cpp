// Why does a spinning top not fall?
//
// A top of 1 kg stands on its point, which does not slip; its middle is half a metre above. Its
// weight turns its angular momentum sideways instead of pulling it down. First the two rates at
// which it can go round steadily, then what becomes of one that is let go: it nods. Last, how far
// the tilt is off after ten seconds by three methods, at the same number of looks at the torque.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/motion/composition.hpp"
#include "carom/motion/gyroscopic_step.hpp"
#include "carom/motion/kicked_rotor.hpp"
#include "carom/motion/rk4_rotor.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::RotorState;
using carom::Vector3;

const Vector3 kMoments(0.3, 0.3, 0.1);  // about the point [kg m^2]
const Vector3 kMiddle(0, 0, 0.5);       // [m, body]
const Vector3 kWeight(0, 0, -9.81);     // [N, world]

//! [torque]
// The weight acts at the middle; the point is where the moments are
// about, so the force at the point has no arm.
Vector3 torqueOfWeight(Real, const RotorState& s) {
  const Vector3 weight = rotatePoint(conjugate(s.q_WB), kWeight);
  return carom::cross(kMiddle, weight);  // along the axes of the body
}
//! [torque]

Vector3 axisOf(const RotorState& s) {
  return rotatePoint(s.q_WB, {0, 0, 1});
}

Real tiltOf(const RotorState& s) {
  const Vector3 axis = axisOf(s);
  return carom::arctangent2(std::hypot(axis.x(), axis.y()), axis.z());
}

// Tilted by an angle, spinning about its own axis and going round the vertical [rad/s].
RotorState top(Real tilt, Real spin, Real precession) {
  const auto [s, c] = carom::sineCosine(tilt / 2);
  RotorState state = {{c, s, 0, 0}, {0, 0, spin}};
  const Vector3 up = rotatePoint(conjugate(state.q_WB), {0, 0, 1});
  state.angularVelocity += precession * Vector3(up.x(), up.y(), 0);
  return state;
}

// An engine's step: torque, gyroscopic term, attitude.
RotorState engineStep(const RotorState& s, Real dt) {
  const carom::Matrix3 inertia = kMoments.asDiagonal();
  Vector3 w = s.angularVelocity + dt * torqueOfWeight(0, s).cwiseQuotient(kMoments);
  w = carom::gyroscopicStep(inertia, w, dt);
  return {integrateOrientation(s.q_WB, rotatePoint(s.q_WB, w), dt), w};
}

//! [quadratic]
// I cos(tilt) W^2 - I3 w3 W + m g l = 0
struct Rates {
  Real slow, fast;  // [rad/s]
};

Rates steadyRates(Real tilt, Real spin) {
  const Real a = kMoments.x() * carom::cosine(tilt);
  const Real b = kMoments.z() * spin, c = 9.81 * kMiddle.z();
  const Real q = (b + std::sqrt(b * b - 4 * a * c)) / 2;
  return {c / q, q / a};  // no difference of near numbers
}
//! [quadratic]

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const carom::SplitRotor body(kMoments);
  const Real tilt = std::numbers::pi / 6;

  std::cout << "A top at 30 degrees that goes round steadily for 10 s\n\n";
  carom::io::Table steady;
  steady.column("spin [rad/s]").column("rate [rad/s]", carom::io::fixed(6));
  steady.column("mgl / (I3 spin)", carom::io::fixed(6));
  steady.column("tilt off by [rad]", carom::io::scientific(1));
  for (Real spin : {60, 30, 23}) {
    const auto [slow, fast] = steadyRates(tilt, spin);
    for (Real rate : {slow, fast}) {
      RotorState s = top(tilt, spin, rate);
      Real worst = 0;
      for (int i = 0; i < 10000; ++i) {
        s = kickedRotor(body, s, 0, 1e-3, carom::kKahanLi6Weights, torqueOfWeight);
        worst = std::max(worst, std::abs(tiltOf(s) - tilt));
      }
      steady.row({spin, rate, 9.81 * 0.5 / (0.1 * spin), worst});
    }
  }
  std::cout << steady;

  // Let go at rest, but for its spin.
  const RotorState start = top(0.5, 40, 0);
  std::vector<RotorState> path = {start};
  for (int i = 0; i < 10000; ++i) {
    path.push_back(
        kickedRotor(body, path.back(), 0, 1e-3, carom::kKahanLi6Weights, torqueOfWeight));
  }
  std::cout << "\nLet go at 0.5 rad with 40 rad/s: the tilt after 10 s is off by [rad]\n\n";
  carom::io::Table table;
  table.column("torques a second").column("engine's step", carom::io::scientific(1));
  table.column("Runge and Kutta's", carom::io::scientific(1));
  table.column("turn and kick, order 2", carom::io::scientific(1));
  for (int torques : {240, 480, 960, 1920}) {
    RotorState a = start, b = start, c = start;
    const Real dt = 1.0 / torques;
    for (int i = 0; i < 10 * torques; ++i) a = engineStep(a, dt);
    for (int i = 0; i < 10 * torques / 4; ++i) {
      b = rk4Rotor(kMoments, b, 0, 4 * dt, torqueOfWeight);
    }
    for (int i = 0; i < 10 * torques; ++i) {
      c = kickedRotor(body, c, 0, dt, carom::kVerletWeights, torqueOfWeight);
    }
    const auto off = [&](const RotorState& s) { return std::abs(tiltOf(s) - tiltOf(path.back())); };
    table.row({torques, off(a), off(b), off(c)});
  }
  std::cout << table;

  carom::io::Plot plot("The path of the top's axis, from above");
  plot.xAxis("x").yAxis("y").equalAspect();
  plot.describe("A ring of arcs that meet in cusps on an inner circle.");
  std::vector<Real> x, y;
  for (int i = 0; i <= 5000; i += 4) {
    x.push_back(axisOf(path[i]).x());
    y.push_back(axisOf(path[i]).y());
  }
  plot.curve("", x, y);
  plot.writeSvg(folder / "spinning_top_precession.svg");

  carom::io::Recording recording("A top that is let go", "It sinks, goes sideways, and comes up.");
  recording.addBody("top", carom::io::Cylinder{0.35, 0.12}, {.axes = true});
  recording.addBody("stem", carom::io::Cylinder{0.03, 1}, {});
  recording.addBody("tip of the axis", carom::io::Ball{0.03}, {.trail = true});
  recording.addFixed("floor", carom::io::Plane{2, 0.5});
  for (int i = 0; i <= 10000; i += 20) {
    const RotorState& s = path[i];
    const Vector3 axis = axisOf(s);
    recording.addFrame(
        {.time = i * 1e-3, .poses = {{0.5 * axis, s.q_WB}, {0.5 * axis, s.q_WB}, {1.0 * axis}}});
  }
  recording.writeHtml(folder / "spinning_top_precession.html");
}
