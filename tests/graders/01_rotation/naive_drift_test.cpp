// Grader of 01.naive_drift: the small sum is run with the library's product, and the last question comes
// from the closed form, which the run confirms.

#include <cmath>
#include <limits>

#include "carom/rotation/hamilton_product.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

// The length of q after `steps` small sums at (3, -4, 12) rad/s.
Real lengthAfter(Real dt, int steps) {
  Quaternion q{1, 0, 0, 0};
  for (int i = 0; i < steps; ++i) {
    const Quaternion rate = hamiltonProduct({0, 3, -4, 12}, q);
    q = {q.w + dt / 2 * rate.w, q.x + dt / 2 * rate.x, q.y + dt / 2 * rate.y,
         q.z + dt / 2 * rate.z};
  }
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

constexpr const char* kFivePercent = "5 % of the number";

// The number that somebody meant, of those that the known ways of thinking lead to: 5 % is allowed, so
// digits alone do not tell two answers apart. `from` is what the 5 % are counted from.
Real meant(const char* name, const char* unitText, Real from, std::initializer_list<Real> known) {
  const Real number = predicted(name, unitText);
  Real nearest = number;
  Real distance = std::numeric_limits<Real>::infinity();
  for (const Real candidate : known) {
    const Real away = std::abs((number - candidate) / (candidate - from));
    if (away < 0.05 && away < distance) {
      distance = away;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace

TEST_CASE("one_step") {
  const Real expected = lengthAfter(0.1, 1);
  GRADE(predicted("one_step", ""), expected,
        within(0.05 * (expected - 1), "5 % of what it is above 1"), given("dt", 0.1, "s"),
        about("the length after one step"));
}

TEST_CASE("ten_seconds") {
  GRADE(predicted("steps_10ms", ""), lengthAfter(0.01, 1000), withinRelative(0.05, kFivePercent),
        given("dt", 0.01, "s"), about("the length after 10 s"));
  GRADE(predicted("steps_5ms", ""), lengthAfter(0.005, 2000), withinRelative(0.05, kFivePercent),
        given("dt", 0.005, "s"), about("the length after 10 s"));
}

TEST_CASE("step_for_one_percent") {
  // ln |q| = T/(2 dt) ln(1 + (13 dt/2)^2), which for such short steps is T 13^2 dt / 8.
  const Real dt = 8 * std::log(1.01) / (10 * 169.0);
  const int steps = static_cast<int>(std::lround(10 / dt));
  REQUIRE(std::abs(lengthAfter(dt, steps) - 1.01) < 1e-6);
  GRADE(predicted("dt_one_percent", "s"), dt, withinRelative(0.05, kFivePercent), unit("s"),
        about("the step that makes the length 1.01 after 10 s"));
}

PROBES() {
  PROBE(meant("one_step", "", 1, {1.1927, 1.64, 1.65}));
  PROBE(meant("steps_10ms", "", 0, {8.23, 4356, 2.24e27}));
  PROBE(meant("steps_5ms", "", 0, {2.874, 67.8, 6.03e27, 4.62}));
  PROBE(meant("dt_one_percent", "s", 0, {4.71e-5, 1.18e-5, 1.53e-4}));
}
