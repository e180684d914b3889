// Grader of 06.measure_order: errors that are a power of the step by construction.

#include "carom/motion/measure_order.hpp"

#include <cmath>

#include "grading/fields_motion.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

void ask(const StepError& coarse, const StepError& fine, Real expected, const char* what) {
  GRADE(measureOrder(coarse, fine), expected, within(1e-12, kRounding),
        given("coarse", coarse, "(s, m)"), given("fine", fine, "(s, m)"), about(what));
}

}  // namespace

TEST_CASE("halved") {
  ask({0.1, 0.16}, {0.05, 0.01}, 4, "half the step makes the error sixteen times smaller");
  ask({0.5, 0.024}, {0.25, 0.003}, 3, "half the step makes the error eight times smaller");
}

TEST_CASE("ratios") {
  ask({0.3, 0.09}, {0.1, 0.01}, 2, "a third of the step makes the error nine times smaller");
  ask({0.1, 2e-3}, {0.01, 2e-6}, 3, "a tenth of the step makes it a thousand times smaller");
  Random random(seed());
  for (int n = 0; n < 12; ++n) {
    const Real p = random.between(0.5, 8), factor = random.between(0.01, 10);
    const Real dt = random.between(0.05, 0.2), finer = dt / random.between(1.1, 8);
    ask({dt, factor * std::pow(dt, p)}, {finer, factor * std::pow(finer, p)}, p,
        "the errors are a power of the step");
  }
}

TEST_CASE("fall") {
  // A stone that falls for 10 s: the two Euler methods are off by g dt/2 times the time.
  const auto error = [](Real dt) { return 9.81 * dt / 2 * 10; };
  ask({1, error(1)}, {0.2, error(0.2)}, 1, "a stone that falls for 10 s, by semi-implicit Euler");
  // Its square instead of itself: order two.
  const auto squared = [&](Real dt) { return error(dt) * error(dt); };
  ask({1, squared(1)}, {0.2, squared(0.2)}, 2, "the squares of these errors");
}

TEST_CASE("refuses") {
  GRADE_REFUSES(measureOrder({0.1, 0.2}, {0.2, 0.1}), given("coarse.dt", 0.1, "s"),
                given("fine.dt", 0.2, "s"));
  GRADE_REFUSES(measureOrder({0.1, 0.2}, {0.05, 0}), given("fine.error", 0.0, "m"));
}

PROBES() {
  Random random(606);
  for (int n = 0; n < 16; ++n) {
    const Real dt = random.between(0.05, 0.2), error = random.between(0.1, 1);
    const StepError fine = {dt / random.between(1.2, 8), error / random.between(1.5, 100)};
    PROBE(measureOrder({dt, error}, fine));
  }
}
