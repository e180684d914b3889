// Grader of 05.stopping_errors: the distance in whole steps is a sum that has a closed form, and
// the error falls with the step.

#include "stopping_errors.hpp"

#include <cmath>

#include "grading/grade.hpp"
#include "stopping_errors_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Reals = std::vector<Real>;

// The row with a number, or one that nothing agrees with if there is none.
StoppingError row(const std::vector<StoppingError>& table, std::size_t number) {
  return number < table.size() ? table[number] : StoppingError{-1, -1, 1};
}

// The speeds at the ends of the steps fall by the same amount, as long as so much is left: h times
// their sum is the distance.
Real distanceInSteps(Real speed, Real friction, Real h) {
  const Real lost = friction * kFloorGravity * h;
  const Real n = std::floor(speed / lost);
  return h * (n * speed - lost * n * (n + 1) / 2);
}

// How many powers the error grows by when the step does.
Real slope(const std::vector<StoppingError>& table) {
  const StoppingError first = row(table, 0),
                      last = row(table, table.empty() ? 0 : table.size() - 1);
  return std::log(last.error / first.error) / std::log(last.step / first.step);
}

}  // namespace

TEST_CASE("table") {
  const Reals steps = {0.01, 0.002, 0.03};
  GRADE(stoppingErrors(4, 0.3, steps).size(), std::size_t{3}, within(0, "a count"),
        given("steps", steps, "s"), about("one row for each step"));
  for (std::size_t k = 0; k < steps.size(); ++k) {
    GRADE(row(stoppingErrors(4, 0.3, steps), k).step, steps[k], within(0, "a copy"),
          given("steps", steps, "s"), given("row", k), unit("s"));
  }
}

TEST_CASE("distance") {
  Random random(seed());
  for (int n = 0; n < 8; ++n) {
    const Real speed = random.between(2, 9), friction = random.between(0.1, 0.9);
    const Real first = random.between(0.01, 0.03), second = random.between(0.002, 0.01);
    const Reals steps = {first, second};
    GRADE(row(stoppingErrors(speed, friction, steps), 1).distance,
          distanceInSteps(speed, friction, second), within(1e-10, "roundings of many steps"),
          given("speed", speed, "m/s"), given("friction", friction), given("steps", steps, "s"),
          unit("m"), about("the second row: how far the crate slides"));
  }
}

TEST_CASE("error") {
  Random random(seed() + 1);
  for (int n = 0; n < 8; ++n) {
    const Real speed = random.between(2, 9), friction = random.between(0.1, 0.9);
    const Reals steps = {random.between(0.0005, 0.001)};
    GRADE(row(stoppingErrors(speed, friction, steps), 0).error, -speed * steps[0] / 2,
          withinRelative(0.01, "what is left out is the square of the step"),
          given("speed", speed, "m/s"), given("friction", friction), given("steps", steps, "s"),
          unit("m"), about("it falls short by half a step of its first speed"));
  }
}

TEST_CASE("slope") {
  const Reals steps = {0.0004, 0.004, 0.04};
  GRADE(slope(stoppingErrors(4, 0.3, steps)), 1, within(0.02, "the squares of the steps"),
        given("steps", steps, "s"), about("slope of the error, both axes logarithmic"));
  GRADE(row(stoppingErrors(4, 0.3, steps), 1).error, -0.008,
        withinRelative(0.02, "the square of the step"), given("step", steps[1], "s"), unit("m"),
        about("the height of that line, in metres"));
}

TEST_CASE("refuses") {
  const Reals none = {0};
  GRADE_REFUSES(stoppingErrors(4, 0.3, none), given("steps", none, "s"));
}

PROBES() {
  Random random(515);
  for (int n = 0; n < 16; ++n) {
    const Real speed = random.between(2, 9), friction = random.between(0.1, 0.9);
    const Real first = random.between(0.01, 0.03);
    const Reals steps = {first, random.between(0.02, 0.05)};
    PROBE(stoppingErrors(speed, friction, steps));
  }
}
