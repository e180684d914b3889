// Grader of 06.velocity_verlet: stones and springs in closed form, the integral of a force that
// depends on time alone, and the order of the method in oil and between magnets.

#include "carom/motion/velocity_verlet.hpp"

#include "graders/06_integrators/motions.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

State after(State state, Real dt, int steps, const Acceleration& force) {
  for (int i = 0; i < steps; ++i) state = velocityVerlet(state, i * dt, dt, force);
  return state;
}

// On a spring with a = -x the positions obey x(i+1) - (2 - dt^2) x(i) + x(i-1) = 0, and
// v^2 + (1 - dt^2/4) x^2 stays: both are cosines and sines of i theta.
State springAfter(Real x, Real v, Real dt, int steps) {
  const Real theta = 2 * std::asin(dt / 2), squeeze = std::cos(theta / 2);
  const Real c = std::cos(steps * theta), s = std::sin(steps * theta);
  return {column({x * c + v / squeeze * s}), column({v * c - x * squeeze * s})};
}

// Motions whose force depends on the velocity, with what is known of them after one second.
struct Known {
  State start;
  Acceleration force;
  State end;
};

// In oil: a = -c v.
Known inOil(Real c) {
  return {
      {column({0}), column({1})},
      forceOn(
          1, [c](Real, const Coordinates&, const Coordinates& v) -> Coordinates { return -c * v; }),
      {column({(1 - std::exp(-c)) / c}), column({std::exp(-c)})}};
}

// A charge between magnets runs round a circle: a = b (v_y, -v_x).
Known betweenMagnets(Real b) {
  return {{column({0, 0}), column({1, 0})},
          forceOn(2,
                  [b](Real, const Coordinates&, const Coordinates& v) -> Coordinates {
                    return column({b * v[1], -b * v[0]});
                  }),
          {column({std::sin(b) / b, (std::cos(b) - 1) / b}), column({std::cos(b), -std::sin(b)})}};
}

Real error(const Known& known, int steps) {
  const State end = after(known.start, 1.0 / steps, steps, known.force);
  if (end.position.size() != known.end.position.size() ||
      end.velocity.size() != known.end.velocity.size()) {
    return std::numeric_limits<Real>::quiet_NaN();
  }
  return (end.position - known.end.position).norm() + (end.velocity - known.end.velocity).norm();
}

// By how much half the step makes the error smaller.
Real gain(const Known& known) {
  return error(known, 40) / error(known, 80);
}

}  // namespace

TEST_CASE("falling") {
  const State rest = {column({0}), column({0})};
  GRADE(after(rest, 1, 10, falling(column({-9.81}))), State({column({-490.5}), column({-98.1})}),
        within(1e-12, kRounding), given("state", rest, "(m, m/s)"), given("dt", 1.0, "s"),
        about("a stone falls from rest with 9.81 m/s^2: after ten steps of 1 s"));
  const State thrown = {column({0, 2}), column({3, 12})};
  GRADE(velocityVerlet(thrown, 0, 0.5, falling(column({0, -9.81}))),
        State({column({1.5, 8 - 9.81 / 8}), column({3, 12 - 9.81 / 2})}), within(1e-14, kRounding),
        given("state", thrown, "(m, m/s)"), given("dt", 0.5, "s"),
        about("a stone thrown at (3, 12) m/s from 2 m of height, after one step"));
}

TEST_CASE("spring") {
  const State stretched = {column({1}), column({0})};
  GRADE(velocityVerlet(stretched, 0, 0.1, springs(1, 1)),
        State({column({0.995}), column({-0.09975})}), within(1e-15, kRounding),
        given("state", stretched, "(m, m/s)"), given("dt", 0.1, "s"),
        about("a spring with a = -x, let go at 1 m: after one step of 0.1 s"));
  Random random(seed());
  for (int n = 0; n < 5; ++n) {
    const Real x = random.between(0.5, 2), v = random.between(-2, 2);
    const Real dt = random.between(0.05, 0.5);
    const int steps = random.integer(50, 200);
    GRADE(after({column({x}), column({v})}, dt, steps, springs(1, 1)), springAfter(x, v, dt, steps),
          within(1e-11, "the roundings of the steps"), given("position", x, "m"),
          given("velocity", v, "m/s"), given("dt", dt, "s"), given("steps", steps),
          about("a spring with a = -x, after many steps"));
  }
}

TEST_CASE("time") {
  Random random(seed() + 1);
  for (int n = 0; n < 6; ++n) {
    const Real rate = random.between(1, 5), t = random.between(0, 3), dt = random.between(0.1, 0.5);
    const Acceleration growing =
        forceOn(1, [rate](Real time, const Coordinates&, const Coordinates&) -> Coordinates {
          return column({rate * time});
        });
    const State rest = {column({0}), column({0})};
    // The velocity is exact: a mean of two is the mean of a straight line.
    GRADE(velocityVerlet(rest, t, dt, growing),
          State({column({dt * dt / 2 * rate * t}),
                 column({rate / 2 * ((t + dt) * (t + dt) - t * t)})}),
          within(1e-13, kRounding), given("state", rest, "(m, m/s)"), given("time", t, "s"),
          given("dt", dt, "s"), given("c", rate, "m/s^3"),
          about("a force that grows with time: a = c t"));
  }
}

TEST_CASE("velocity") {
  GRADE(gain(inOil(1)), 4, within(0.3, "the next power of the step"),
        about("in oil, a = -v, for one second: how many times smaller the error is with 80 steps "
              "than with 40"));
  GRADE(error(inOil(1), 40), 0, within(3e-4, "some dt^2"),
        about("in oil, a = -v: error of position and velocity after 40 steps of 1/40 s"));
  GRADE(gain(betweenMagnets(2)), 4, within(0.3, "the next power of the step"),
        about("a charge between magnets, a = 2 (v_y, -v_x), for one second: how many times smaller "
              "the error is with 80 steps than with 40"));
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const State odd = {column({nan}), column({0})};
  GRADE_REFUSES(velocityVerlet(odd, 0, 0.1, springs(1, 1)), given("state", odd, "(m, m/s)"));
}

PROBES() {
  Random random(604);
  for (int n = 0; n < 16; ++n) {
    const MadeUp motion(random, random.integer(1, 2));
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.5);
    PROBE(velocityVerlet(motion.at(t), t, dt, motion.force()));
  }
}
