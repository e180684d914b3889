// When does a sliding ball begin to roll, and how fast is it then?
//
// A ball is thrown along a lane without spin, with back spin, or with side spin. Friction brakes the
// slip of its lowest point; when nothing slips any more, it rolls. Steps of 1/60 s with the
// library's friction, beside the exact answer for a solid ball, a hollow one and a hoop.

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/impulse/friction_impulse.hpp"
#include "carom/impulse/point_velocity.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector3;

constexpr Real kFriction = 0.2, kGravity = 9.81;  // [1], [m/s^2]
constexpr Real kRadius = 0.5;                     // [m]
constexpr Real kStep = 1.0 / 60;                  // [s]
const Vector3 kUp = Vector3::UnitZ();

struct Throw {
  std::string name;
  Vector3 velocity;  // [m/s]
  Vector3 rimSpeed;  // angular velocity times the radius [m/s]
  Real k = 0.4;      // inertia over m R^2: 2/5 solid, 2/3 hollow, 1 hoop
};

struct Rolling {
  Vector3 x{0, 0, kRadius};  // [m]
  carom::Velocity motion;
};

//! [step]
// Friction acts at the lowest point and changes both velocities, per kg.
void step(Rolling& ball, Real k) {
  const Vector3 arm = -kRadius * kUp;
  const Vector3 slip = carom::pointVelocity(ball.motion, arm);
  // At the lowest point an impulse also turns the ball: it feels lighter.
  const Real mass = 1 / (1 + 1 / k);
  const Real pressed = kGravity * kStep;  // normal impulse
  const Vector3 J = carom::frictionImpulse(slip, kUp, pressed, kFriction, mass);
  const Real inertia = k * kRadius * kRadius;
  ball.motion.linear += J;
  ball.motion.angular += carom::cross(arm, J) / inertia;
  ball.x += kStep * ball.motion.linear;
}
//! [step]

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<Throw> throws = {{"solid ball", {7, 0, 0}, {0, 0, 0}, 0.4},
                                     {"hollow ball", {7, 0, 0}, {0, 0, 0}, 2.0 / 3},
                                     {"hoop", {7, 0, 0}, {0, 0, 0}, 1},
                                     {"back spin", {4, 0, 0}, {0, -20, 0}, 0.4},
                                     {"side spin", {2, 0, 0}, {-30, 10, 0}, 0.4}};
  carom::io::Recording recording(
      "A ball that slides begins to roll",
      "A striped ball is thrown along a lane: it slides, its spin grows, and it rolls on with five "
      "sevenths of its speed. With back spin it comes back; with side spin it runs in a curve.");
  recording.setParameter("thrown as");
  recording.addFixed("lane", carom::io::Plane{40, 1});
  recording.addBody("ball", carom::io::Ball{kRadius}, {.trail = true});
  recording.addChannel("speed", "m/s");
  recording.addChannel("slip", "m/s");
  recording.setView({.direction = Vector3(-0.1, 1, -0.7)});

  carom::io::Table table;
  table.column("").column("rolls [s]", carom::io::fixed(4));
  table.column("in steps", carom::io::fixed(4)).column("v [m/s]", carom::io::fixed(4));
  table.column("in steps", carom::io::fixed(4)).column("x [m]", carom::io::fixed(3));
  table.column("in steps", carom::io::fixed(3));
  carom::io::Plot plot("Seen from above: a ball with side spin");
  plot.xAxis("x [m]").yAxis("y [m]").equalAspect();
  for (const Throw& thrown : throws) {
    //! [exact]
    // When the slip has gone, and where and how fast the ball is then.
    const Vector3 spin = thrown.rimSpeed / kRadius;
    const carom::TableLaw law{kRadius, kFriction, kGravity, thrown.k};
    const carom::TableBall start{{0, 0}, thrown.velocity.head<2>(), spin};
    const Real time = carom::timeToRoll(start, law);
    const carom::TableBall truth = carom::rollBall(start, law, time);
    //! [exact]
    Rolling ball;
    ball.motion = {thrown.velocity, spin};
    carom::Quaternion q{1, 0, 0, 0};
    recording.beginCase(thrown.name);
    std::vector<Real> x, y;
    Real rollsAt = -1, placeThen = 0;
    for (int i = 0; i <= 300; ++i) {
      const Real slip = carom::pointVelocity(ball.motion, -kRadius * kUp).norm();
      if (rollsAt < 0 && slip < 1e-9) rollsAt = i * kStep, placeThen = ball.x.x();
      recording.addFrame({i * kStep, {{ball.x, q}}, {ball.motion.linear.norm(), slip}, {}});
      x.push_back(ball.x.x());
      y.push_back(ball.x.y());
      step(ball, thrown.k);
      q = carom::integrateOrientation(q, ball.motion.angular, kStep);
    }
    if (thrown.name == "side spin") {
      plot.curve("path", x, y);
      plot.points("begins to roll", {truth.position.x()}, {truth.position.y()});
    }
    table.row({thrown.name, time, rollsAt, truth.velocity.norm(), ball.motion.linear.norm(),
               truth.position.x(), placeThen});
  }
  std::cout << table;
  plot.writeSvg(folder / "slide_to_roll.svg");
  recording.writeHtml(folder / "slide_to_roll.html");
}
