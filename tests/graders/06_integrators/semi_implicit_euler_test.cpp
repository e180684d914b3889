// Grader of 06.semi_implicit_euler: stones and springs in closed form, what a spring keeps, and
// motions that were made up first and got their force afterwards.

#include "carom/motion/semi_implicit_euler.hpp"

#include "graders/06_integrators/motions.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

State after(State state, Real dt, int steps, const Acceleration& force) {
  for (int i = 0; i < steps; ++i) state = semiImplicitEuler(state, i * dt, dt, force);
  return state;
}

// What a spring with a = -x keeps.
Real tiltedEllipse(const State& s, Real dt) {
  const Real x = s.position[0], v = s.velocity[0];
  return x * x + v * v - dt * x * v;
}

// The positions of the spring obey x(i+1) - (2 - dt^2) x(i) + x(i-1) = 0: a cosine and a sine.
Real springAfter(Real x, Real v, Real dt, int steps) {
  const Real theta = 2 * std::asin(dt / 2);
  const Real first = x + dt * (v - dt * x);
  return x * std::cos(steps * theta) +
         (first - x * std::cos(theta)) / std::sin(theta) * std::sin(steps * theta);
}

}  // namespace

TEST_CASE("falling") {
  const State rest = {column({0}), column({0})};
  const Acceleration stone = falling(column({-9.81}));
  GRADE(semiImplicitEuler(rest, 0, 0.1, stone), State({column({-0.0981}), column({-0.981})}),
        within(1e-15, kRounding), given("state", rest, "(m, m/s)"), given("dt", 0.1, "s"),
        about("a stone falls from rest with 9.81 m/s^2: after the first tenth of a second"));
  // a h^2 (1 + 2 + ... + n).
  GRADE(after(rest, 1, 10, stone), State({column({-9.81 * 55}), column({-98.1})}),
        within(1e-12, kRounding), given("state", rest, "(m, m/s)"), given("dt", 1.0, "s"),
        about("the same stone after ten steps of 1 s"));
}

TEST_CASE("spring") {
  const State stretched = {column({1}), column({0})};
  GRADE(semiImplicitEuler(stretched, 0, 0.1, springs(1, 1)),
        State({column({0.99}), column({-0.1})}), within(1e-15, kRounding),
        given("state", stretched, "(m, m/s)"), given("dt", 0.1, "s"),
        about("a spring with a = -x, let go at 1 m: after one step of 0.1 s"));
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const State state = {column({random.between(0.5, 2)}), column({random.between(-2, 2)})};
    const Real dt = random.between(0.05, 0.5);
    const int steps = random.integer(50, 200);
    GRADE(tiltedEllipse(after(state, dt, steps, springs(1, 1)), dt), tiltedEllipse(state, dt),
          within(1e-11, "the roundings of the steps"), given("state", state, "(m, m/s)"),
          given("dt", dt, "s"), given("steps", steps),
          about("x^2 + v^2 - dt x v after many steps of a spring"));
    GRADE(after(state, dt, steps, springs(1, 1)).position[0],
          springAfter(state.position[0], state.velocity[0], dt, steps),
          within(1e-11, "the roundings of the steps"), given("state", state, "(m, m/s)"),
          given("dt", dt, "s"), given("steps", steps), unit("m"),
          about("where the spring is then"));
  }
}

TEST_CASE("any") {
  Random random(seed() + 1);
  for (int n = 0; n < 12; ++n) {
    const MadeUp motion(random, random.integer(1, 3));
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.5);
    const State now = motion.at(t);
    const Coordinates way = dt * motion.velocity(t), kick = dt * motion.acceleration(t);
    GRADE(semiImplicitEuler(now, t, dt, motion.force()),
          State({now.position + way + dt * kick, now.velocity + kick}), within(1e-13, kRounding),
          given("state", now, "(m, m/s)"), given("time", t, "s"), given("dt", dt, "s"),
          given("acceleration now", motion.acceleration(t), "m/s^2"),
          about("a force that depends on time, place and velocity"));
  }
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const State odd = {column({0}), column({nan})};
  GRADE_REFUSES(semiImplicitEuler(odd, 0, 0.1, springs(1, 1)), given("state", odd));
}

PROBES() {
  Random random(602);
  for (int n = 0; n < 16; ++n) {
    const MadeUp motion(random, random.integer(1, 2));
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.5);
    PROBE(semiImplicitEuler(motion.at(t), t, dt, motion.force()));
  }
}
