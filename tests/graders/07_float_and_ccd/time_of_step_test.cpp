// Grader of 07.time_of_step: whole durations divided into equal steps, which must come out whole.

#include "carom/precision/time_of_step.hpp"

#include <cmath>

#include "carom/core/random.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "three roundings: of dt, of the product and of the sum";
constexpr Real kStep = 3.4e-16;

}  // namespace

TEST_CASE("few") {
  GRADE(timeOfStep(0, 0.25, 3), 3, within(0, "nothing has been added"), unit("s"),
        given("dt", 0.25, "s"), given("start", 3.0, "s"), about("before the first step"));
  GRADE(timeOfStep(3, 0.1, 0), 0.3, withinRelative(kStep, kRounding), unit("s"),
        given("dt", 0.1, "s"), given("start", 0.0, "s"), about("after three steps of a tenth"));
  GRADE(timeOfStep(-8, 0.25, 0), -2, within(0, "exactly"), unit("s"), given("dt", 0.25, "s"),
        given("start", 0.0, "s"), about("eight steps before the start"));
}

TEST_CASE("start") {
  Random random(seed());
  for (int n = 0; n < 6; ++n) {
    const int second = random.integer(2, 50), perSecond = random.integer(3, 200);
    const Real start = random.integer(1, 400) / 4.0, dt = 1.0 / perSecond;
    GRADE(timeOfStep(second * perSecond, dt, start), start + second,
          withinRelative(kStep, kRounding), given("step", second * perSecond), given("dt", dt, "s"),
          given("start", start, "s"), unit("s"),
          about("a whole number of seconds after the start"));
  }
}

TEST_CASE("long") {
  GRADE(timeOfStep(216000, 1 / 60.0, 0), 3600, withinRelative(kStep, kRounding),
        given("step", 216000), given("dt", 1 / 60.0, "s"), given("start", 0.0, "s"), unit("s"),
        about("an hour of sixtieths"));
  Random random(seed() + 1);
  for (int n = 0; n < 6; ++n) {
    const int perSecond = random.integer(23, 240) * 10 + 3, seconds = random.integer(700, 1500);
    GRADE(timeOfStep(seconds * perSecond, 1.0 / perSecond, 0), seconds,
          withinRelative(kStep, kRounding), given("step", seconds * perSecond),
          given("dt", 1.0 / perSecond, "s"), given("start", 0.0, "s"), unit("s"),
          about("a whole number of seconds, in a million steps or so"));
  }
}

TEST_CASE("count") {
  GRADE(timeOfStep(-3000000000, 0.001, 0), -3e6, withinRelative(kStep, kRounding),
        given("step", std::int64_t{-3000000000}), given("dt", 0.001, "s"), given("start", 0.0, "s"),
        unit("s"), about("35 days before the start, at 1 kHz"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(timeOfStep(1, std::nan(""), 0), given("dt", std::nan("")));
}

PROBES() {
  Random random(704);
  for (int n = 0; n < 16; ++n) {
    const Real dt = random.between(0.001, 0.1), start = random.between(1, 100);
    PROBE(timeOfStep(random.integer(20000, 90000), dt, start));
  }
  PROBE(timeOfStep(-4000000007, 0.25, 1));
}
