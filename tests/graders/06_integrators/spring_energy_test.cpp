// Grader of 06.spring_energy: the library's own methods follow the springs.

#include <cmath>
#include <limits>

#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "graders/06_integrators/motions.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Within kMargin = withinRelative(0.05, "a prediction may be 5% off");

// Let go with 1 J, stretched and moving.
const State kStart = {column({1}), column({1})};

Real energyAfter(Real dt, int steps) {
  return energyOfSprings(simulate(explicitEuler, kStart, 0, dt, steps, springs(1, 1)), 1);
}

Real error(const Step& step, int steps) {
  const Real end = 10;
  const State last = simulate(step, kStart, 0, end / steps, steps, springs(1, 1));
  const Real x = std::cos(end) + std::sin(end), v = std::cos(end) - std::sin(end);
  return std::hypot(last.position[0] - x, last.velocity[0] - v);
}

Real leftWithHalfTheStep(const Step& step) {
  return error(step, 400) / error(step, 200);
}

// The longest step with which velocity Verlet does not explode, by halving what is between.
Real longestStep(Real omega) {
  Real good = 0.1 / omega, bad = 4 / omega;
  while (bad - good > 1e-4 / omega) {
    const Real dt = (good + bad) / 2;
    const State end = simulate(velocityVerlet, kStart, 0, dt, 100, springs(1, omega));
    (end.position.squaredNorm() < 1e6 ? good : bad) = dt;
  }
  return good;
}

}  // namespace

TEST_CASE("energy") {
  GRADE(predicted("energy_long_steps", "J"), energyAfter(0.1, 100), kMargin, unit("J"),
        about("explicit Euler, 100 steps of 0.1 s: the energy of a spring that had 1 J"));
}

TEST_CASE("shorter") {
  GRADE(predicted("energy_short_steps", "J"), energyAfter(0.05, 200), kMargin, unit("J"),
        about("explicit Euler, 200 steps of 0.05 s: the energy of a spring that had 1 J"));
}

TEST_CASE("halved") {
  GRADE(predicted("error_semi_implicit", "mm"), 8 * leftWithHalfTheStep(semiImplicitEuler), kMargin,
        unit("mm"), about("semi-implicit Euler: what half the step leaves of 8 mm"));
  GRADE(predicted("error_rk4", "mm"), 3.2 * leftWithHalfTheStep(rk4), kMargin, unit("mm"),
        about("Runge and Kutta's method: what half the step leaves of 3.2 mm"));
}

TEST_CASE("longest") {
  GRADE(predicted("longest_step", "s"), longestStep(20), kMargin, unit("s"),
        about("velocity Verlet at 20 rad/s: the longest step that does not explode"));
}

PROBES() {
  PROBE(predicted("energy_long_steps", "J"));
  PROBE(predicted("energy_short_steps", "J"));
  PROBE(predicted("error_semi_implicit", "mm"));
  PROBE(predicted("error_rk4", "mm"));
  PROBE(predicted("longest_step", "s"));
}
