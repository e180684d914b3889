// Grader of 06.explicit_euler: stones and springs in closed form, and motions that were made up
// first and got their force afterwards.

#include "carom/motion/explicit_euler.hpp"

#include "graders/06_integrators/motions.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

State after(State state, Real dt, int steps, const Acceleration& force) {
  for (int i = 0; i < steps; ++i) state = explicitEuler(state, i * dt, dt, force);
  return state;
}

Real energyRatio(const State& state, Real dt, Real omega) {
  const State next = explicitEuler(state, 0, dt, springs(state.position.size(), omega));
  return energyOfSprings(next, omega) / energyOfSprings(state, omega);
}

}  // namespace

TEST_CASE("falling") {
  const State rest = {column({0}), column({0})};
  const Acceleration stone = falling(column({-9.81}));
  GRADE(explicitEuler(rest, 0, 0.1, stone), State({column({0}), column({-0.981})}),
        within(1e-15, kRounding), given("state", rest, "(m, m/s)"), given("dt", 0.1, "s"),
        about("a stone falls from rest with 9.81 m/s^2: after the first tenth of a second"));
  // n h v and a h^2 (0 + 1 + ... + n-1).
  GRADE(after(rest, 1, 10, stone), State({column({-9.81 * 45}), column({-98.1})}),
        within(1e-12, kRounding), given("state", rest, "(m, m/s)"), given("dt", 1.0, "s"),
        about("the same stone after ten steps of 1 s"));
  const State thrown = {column({0, 2}), column({3, 12})};
  GRADE(after(thrown, 0.25, 4, falling(column({0, -9.81}))),
        State({column({3, 14 - 9.81 * 0.0625 * 6}), column({3, 12 - 9.81})}),
        within(1e-13, kRounding), given("state", thrown, "(m, m/s)"), given("dt", 0.25, "s"),
        about("a stone thrown at (3, 12) m/s from 2 m of height, after four steps"));
}

TEST_CASE("spring") {
  const State stretched = {column({1}), column({0})};
  GRADE(explicitEuler(stretched, 0, 0.1, springs(1, 1)), State({column({1}), column({-0.1})}),
        within(1e-15, kRounding), given("state", stretched, "(m, m/s)"), given("dt", 0.1, "s"),
        about("a spring with a = -x, let go at 1 m: after one step of 0.1 s"));
  Random random(seed());
  for (int n = 0; n < 8; ++n) {
    const State state = {column({random.between(0.5, 2), random.between(-2, 2)}),
                         column({random.between(0.5, 2), random.between(-2, 2)})};
    const Real dt = random.between(0.02, 0.2), omega = random.between(1, 4);
    GRADE(energyRatio(state, dt, omega), 1 + omega * omega * dt * dt, within(1e-13, kRounding),
          given("state", state, "(m, m/s)"), given("dt", dt, "s"), given("omega", omega, "rad/s"),
          about("springs with a = -omega^2 x: energy after one step, divided by that before"));
  }
}

TEST_CASE("any") {
  Random random(seed() + 1);
  for (int n = 0; n < 12; ++n) {
    const MadeUp motion(random, random.integer(1, 3));
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.5);
    const State now = motion.at(t);
    // The step goes along the tangents of the motion.
    GRADE(
        explicitEuler(now, t, dt, motion.force()),
        State({now.position + dt * motion.velocity(t), now.velocity + dt * motion.acceleration(t)}),
        within(1e-13, kRounding), given("state", now, "(m, m/s)"), given("time", t, "s"),
        given("dt", dt, "s"), given("acceleration now", motion.acceleration(t), "m/s^2"),
        about("a force that depends on time, place and velocity"));
  }
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const State odd = {column({nan}), column({0})};
  GRADE_REFUSES(explicitEuler(odd, 0, 0.1, springs(1, 1)), given("state", odd));
}

PROBES() {
  Random random(601);
  for (int n = 0; n < 16; ++n) {
    const MadeUp motion(random, random.integer(1, 2));
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.5);
    PROBE(explicitEuler(motion.at(t), t, dt, motion.force()));
  }
}
