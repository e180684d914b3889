// Grader of 06.rk4: integrals that the method has exactly, the Taylor series of a spring, motions
// that were made up first, and the order on the source's own equation.

#include "carom/motion/rk4.hpp"

#include "graders/06_integrators/motions.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

// y' = 1 + y^2 with y for the velocity: y is the tangent of the time.
Real tangentError(int steps) {
  const Acceleration slope =
      forceOn(1, [](Real, const Coordinates&, const Coordinates& v) -> Coordinates {
        return column({1 + v[0] * v[0]});
      });
  State state = {column({0}), column({0})};
  const Real end = 1.3, dt = end / steps;
  for (int i = 0; i < steps; ++i) state = rk4(state, i * dt, dt, slope);
  if (state.velocity.size() != 1) return std::numeric_limits<Real>::quiet_NaN();
  return std::abs(state.velocity[0] - std::tan(end));
}

// A spring with z = omega dt: cosine and sine up to the fourth power of z.
State taylor(const State& s, Real dt, Real omega) {
  const Real z = omega * dt, even = 1 - z * z / 2 + z * z * z * z / 24, odd = 1 - z * z / 6;
  return {even * s.position + dt * odd * s.velocity,
          even * s.velocity - omega * omega * dt * odd * s.position};
}

}  // namespace

TEST_CASE("integral") {
  Random random(seed());
  for (int n = 0; n < 8; ++n) {
    const Real b = random.between(1, 4), c = random.between(1, 4);
    const Real dt = random.between(0.2, 1), v = random.between(-2, 2);
    const Acceleration force =
        forceOn(1, [b, c](Real t, const Coordinates&, const Coordinates&) -> Coordinates {
          return column({b * t + c * t * t});
        });
    const State start = {column({0}), column({v})};
    const Real h2 = dt * dt, h3 = h2 * dt;
    GRADE(rk4(start, 0, dt, force),
          State({column({v * dt + b * h3 / 6 + c * h2 * h2 / 12}),
                 column({v + b * h2 / 2 + c * h3 / 3})}),
          within(1e-13, kRounding), given("state", start, "(m, m/s)"), given("dt", dt, "s"),
          given("b", b, "m/s^3"), given("c", c, "m/s^4"),
          about("a force that changes with time, a = b t + c t^2: the exact integrals"));
  }
}

TEST_CASE("spring") {
  const State stretched = {column({1}), column({0})};
  GRADE(rk4(stretched, 0, 0.1, springs(1, 1)),
        State({column({1 - 0.005 + 1e-4 / 24}), column({-0.1 + 0.001 / 6})}),
        within(1e-15, kRounding), given("state", stretched, "(m, m/s)"), given("dt", 0.1, "s"),
        about("a spring with a = -x, let go at 1 m: after one step of 0.1 s"));
  Random random(seed() + 1);
  for (int n = 0; n < 8; ++n) {
    const State state = {column({random.between(0.5, 2), random.between(-2, 2)}),
                         column({random.between(-2, 2), random.between(0.5, 2)})};
    const Real dt = random.between(0.1, 0.5), omega = random.between(1, 4);
    GRADE(rk4(state, 0, dt, springs(2, omega)), taylor(state, dt, omega), within(1e-13, kRounding),
          given("state", state, "(m, m/s)"), given("dt", dt, "s"), given("omega", omega, "rad/s"),
          about("two springs with a = -omega^2 x: after one step"));
  }
}

TEST_CASE("any") {
  Random random(seed() + 2);
  for (int n = 0; n < 12; ++n) {
    const MadeUp motion(random, random.integer(1, 3));
    const Real t = random.between(0, 5), dt = random.between(0.01, 0.02);
    GRADE(rk4(motion.at(t), t, dt, motion.force()), motion.at(t + dt),
          within(1e-8, "the fifth power of the step"), given("state", motion.at(t), "(m, m/s)"),
          given("time", t, "s"), given("dt", dt, "s"),
          about("a force that depends on time, place and velocity: after a short step"));
  }
}

TEST_CASE("order") {
  GRADE(tangentError(20) / tangentError(40), 16, within(1.6, "the next power of the step"),
        about("y' = 1 + y^2, from y(0) = 0 to y(1.3) = tan(1.3), with y for the velocity: how many "
              "times smaller the error is with 40 steps than with 20"));
  GRADE(tangentError(40), 0, within(1e-5, "the fourth power of the step, and a factor"),
        about("the same equation: error after 40 steps"));
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const State odd = {column({nan}), column({0})};
  GRADE_REFUSES(rk4(odd, 0, 0.1, springs(1, 1)), given("state", odd, "(m, m/s)"));
}

PROBES() {
  Random random(605);
  for (int n = 0; n < 16; ++n) {
    const MadeUp motion(random, random.integer(1, 2));
    const Real t = random.between(0, 5), dt = random.between(0.2, 0.8);
    PROBE(rk4(motion.at(t), t, dt, motion.force()));
  }
}
