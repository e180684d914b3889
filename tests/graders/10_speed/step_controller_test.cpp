// Grader of 10.step_controller: errors for which the next length is known without a root.

#include "carom/motion/step_controller.hpp"

#include <cmath>
#include <limits>

#include "grading/fields_motion.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kFar = 1e6;  // to the end, where the end shall not matter [s]

// A step of a method whose next one should be `factor` times as long.
StepTry stepFor(Real factor, Real length, Real tolerance, int order, Real left = kFar) {
  StepTry done;
  done.length = length;
  done.left = left;
  done.duration = 2 * left;
  done.tolerance = tolerance;
  done.order = order;
  // So much of its share that nine tenths of what would just do is the factor.
  done.error = std::pow(0.9 / factor, order) * tolerance * length / done.duration;
  return done;
}

void ask(const StepTry& done, const StepChoice& expected, const char* what) {
  GRADE(stepController(done), expected, withinRelative(1e-11, "roundings of the root"),
        given("done", done, "s, m"), about(what));
}

}  // namespace

TEST_CASE("share") {
  StepTry done;
  done.length = 0.25, done.left = 4, done.duration = 8, done.tolerance = 1e-3;
  // A share of 1/32 of the tolerance.
  done.order = 1, done.error = 1e-3 / 64;
  ask(done, {true, 0.45, 0.45}, "half of the step's share, a method of order one");
  done.error = 1e-3 / 16;
  ask(done, {false, 0.1125, 0.1125}, "twice the step's share, a method of order one");
  done.error = 0.95e-3 / 32;
  ask(done, {true, 0.225 / 0.95, 0.225 / 0.95}, "95 % of the share: good, if only just");
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Real factor = random.between(0.3, 0.85), length = random.between(0.01, 0.1);
    const StepTry tried = stepFor(factor, length, 1e-6, 2);
    ask(tried, {false, factor * length, factor * length}, "too much for a step of its length");
  }
}

TEST_CASE("order") {
  Random random(seed());
  for (int order = 1; order <= 8; ++order) {
    const Real factor = random.between(1.3, 4.5), length = random.between(0.01, 0.1);
    ask(stepFor(factor, length, 1e-6, order), {true, factor * length, factor * length},
        "the used part of the share goes with length^order");
  }
  ask(stepFor(40, 0.1, 1e-6, 2), {true, 0.5, 0.5}, "hardly any error: five times as long");
  ask(stepFor(0.01, 0.1, 1e-6, 2), {false, 0.02, 0.02}, "far too much: a fifth as long");
  StepTry none = stepFor(1, 0.1, 1e-6, 4);
  none.error = 0;
  ask(none, {true, 0.5, 0.5}, "no error at all: five times as long");
}

TEST_CASE("refused") {
  for (const Real factor : {4.0, 2.0, 1.2}) {
    StepTry done = stepFor(factor, 0.1, 1e-6, 3);
    done.refusedBefore = true;
    ask(done, {true, 0.1, 0.1}, "a good step after a refused one");
  }
  StepTry less = stepFor(0.95, 0.1, 1e-6, 3);
  less.refusedBefore = true;
  ask(less, {true, 0.095, 0.095}, "a step that is only just good, after a refused one");
  StepTry again = stepFor(0.5, 0.1, 1e-6, 3);
  again.refusedBefore = true;
  ask(again, {false, 0.05, 0.05}, "refused twice");
  StepTry lost = stepFor(1, 0.1, 1e-6, 3);
  lost.error = kNan;
  ask(lost, {false, 0.02, 0.02}, "an error that is not a number");
  lost.error = std::numeric_limits<Real>::infinity();
  ask(lost, {false, 0.02, 0.02}, "an error without limits");
}

TEST_CASE("end") {
  ask(stepFor(2, 1, 1e-6, 4, 2.5), {true, 2, 1.5}, "wants 2 s, and 1.5 s are left after the step");
  ask(stepFor(2, 1, 1e-6, 4, 4.5), {true, 2, 1.75}, "wants 2 s, and 3.5 s are left after the step");
  ask(stepFor(2, 1, 1e-6, 4, 5.5), {true, 2, 2}, "wants 2 s, and 4.5 s are left after the step");
  ask(stepFor(2, 1, 1e-6, 4, 1), {true, 2, 0}, "that was the last step");
  ask(stepFor(0.6, 1, 1e-6, 4, 1), {false, 0.6, 0.5},
      "wants 0.6 s, the last second has to be made again");
  ask(stepFor(0.6, 1, 1e-6, 4, 1.5), {false, 0.6, 0.6}, "wants 0.6 s, 1.5 s have to be made again");
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Real left = random.between(1.3, 2.3);
    ask(stepFor(1.2, 1, 1e-6, 2, 1 + left), {true, 1.2, left / 2}, "two steps are left");
  }
}

TEST_CASE("refuses") {
  StepTry done = stepFor(2, 1, 1e-6, 4);
  done.tolerance = 0;
  GRADE_REFUSES(stepController(done), given("done", done, "s, m"));
}

PROBES() {
  Random random(1040);
  for (int n = 0; n < 32; ++n) {
    const Real factors[] = {0.05, 0.5, 0.92, 1.5, 2.5, 8, 3, 0.7};
    const Real length = random.between(0.5, 1), left = length * random.between(1, 6);
    const Real factor = factors[n % 8] * random.between(0.99, 1.01);
    StepTry done = stepFor(factor, length, 1e-5, 1 + n % 5, left);
    done.refusedBefore = n % 3 == 0;
    if (n == 11) done.error = kNan;
    if (n == 14) done.error = 0;
    PROBE(stepController(done));
  }
}
