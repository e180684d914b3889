// Grader of 00.bounce_back: squares of simple numbers, and a flight that is followed step by step
// instead of by a formula for e.

#include "bounce_back.hpp"

#include <cmath>
#include <limits>

#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kGravity = 9.81;  // [m/s²]
constexpr const char* kRounding = "a division and a square root, each rounded once";

// The height that a ball reaches after one bounce: the fall gives a speed, e takes its share, and
// the rise uses it up.
Real heightAfterBounce(Real dropHeight, Real e) {
  const Real fallTime = std::sqrt(2 * dropHeight / kGravity);
  const Real after = e * kGravity * fallTime;
  const Real riseTime = after / kGravity;
  return after * riseTime - kGravity * riseTime * riseTime / 2;
}

}  // namespace

TEST_CASE("quarter") {
  GRADE(restitutionForHeight(1, 0.25), 0.5, within(1e-15, kRounding), given("dropHeight", 1.0, "m"),
        given("returnHeight", 0.25, "m"));
  GRADE(restitutionForHeight(9, 4), 2.0 / 3, within(1e-15, kRounding),
        given("dropHeight", 9.0, "m"), given("returnHeight", 4.0, "m"));
  GRADE(restitutionForHeight(100, 1), 0.1, within(1e-15, kRounding),
        given("dropHeight", 100.0, "m"), given("returnHeight", 1.0, "m"));
}

TEST_CASE("direction") {
  GRADE(restitutionForHeight(4, 1), 0.5, within(1e-15, kRounding), given("dropHeight", 4.0, "m"),
        given("returnHeight", 1.0, "m"));
  GRADE(restitutionForHeight(2, 2), 1.0, within(1e-15, kRounding), given("dropHeight", 2.0, "m"),
        given("returnHeight", 2.0, "m"), about("nothing is lost, so the speed is the same"));
  GRADE(restitutionForHeight(2, 0), 0.0, within(0, "the root of zero is exact"),
        given("dropHeight", 2.0, "m"), given("returnHeight", 0.0, "m"),
        about("the ball stays on the floor"));
}

TEST_CASE("flight") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Real dropHeight = random.between(0.1, 20);
    const Real returnHeight = dropHeight * random.between(0.02, 0.98);
    GRADE(heightAfterBounce(dropHeight, restitutionForHeight(dropHeight, returnHeight)),
          returnHeight, withinRelative(1e-14, "a dozen roundings of the flight"),
          given("dropHeight", dropHeight, "m"), given("returnHeight", returnHeight, "m"), unit("m"),
          about("the height that the ball reaches with your coefficient"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(restitutionForHeight(1, 1.5), given("dropHeight", 1.0, "m"),
                given("returnHeight", 1.5, "m"), about("a bounce adds no energy"));
  GRADE_REFUSES(restitutionForHeight(0, 0), given("dropHeight", 0.0, "m"),
                given("returnHeight", 0.0, "m"), about("from height zero there is no fall"));
  GRADE_REFUSES(restitutionForHeight(1, -0.1), given("dropHeight", 1.0, "m"),
                given("returnHeight", -0.1, "m"));
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(restitutionForHeight(nan, 0.5), given("dropHeight", nan, "m"),
                given("returnHeight", 0.5, "m"));
}

PROBES() {
  Random random(11);
  for (int n = 0; n < 16; ++n) {
    const Real dropHeight = random.between(0.1, 20);
    const Real returnHeight = dropHeight * random.between(0.02, 0.98);
    PROBE(restitutionForHeight(dropHeight, returnHeight));
  }
}
