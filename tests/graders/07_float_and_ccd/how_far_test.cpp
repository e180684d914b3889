// Grader of 07.how_far: pictures are taken, and steps made.

#include <cmath>

#include "carom/toi/conservative_advancement.hpp"
#include "carom/toi/tunnels.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kMargin = "a prediction may be 5% off";

// The longest step in microseconds, found by halving.
Real longestStep() {
  Real safe = 0, open = 1;
  for (int i = 0; i < 60; ++i) {
    const Real middle = (safe + open) / 2;
    (tunnels(0.008, 0.012, 900, middle) ? open : safe) = middle;
  }
  return 1e6 * safe;
}

// Out of ten thousand starts, which are never seen? In per cent.
Real missed() {
  const Real jump = 72 * 0.11;
  int unseen = 0;
  for (int n = 0; n < 10000; ++n) {
    bool seen = false;
    for (Real front = -jump * (n + 0.5) / 10000; front <= 7.2; front += jump) {
      seen = seen || front >= 0;
    }
    if (!seen) ++unseen;
  }
  return unseen / 100.0;
}

Real stepsForNineDigits() {
  return conservativeAdvancement([](Real t) { return 1 - t; }, 2, 2, 1e-9).steps;
}

}  // namespace

TEST_CASE("jump") {
  GRADE(predicted("jump", "m"), 72 * 0.1, withinRelative(0.05, kMargin), unit("m"),
        about("how far the car goes from picture to picture"));
}

TEST_CASE("bullet") {
  GRADE(predicted("longest_step", "us"), longestStep(), withinRelative(0.05, kMargin), unit("us"),
        about("the longest step in which the bullet cannot pass the wall unseen"));
}

TEST_CASE("share") {
  GRADE(predicted("missed", "%"), missed(), withinRelative(0.05, kMargin), unit("%"),
        about("the share of starts from which the cars are never seen to touch"));
}

TEST_CASE("advances") {
  GRADE(predicted("steps_for_nine_digits", "steps"), stepsForNineDigits(),
        within(0.5, "a number of steps is whole"), unit("steps"),
        about("steps with a bound of twice the speed"));
}

PROBES() {
  PROBE(predicted("jump", "m"));
  PROBE(predicted("longest_step", "us"));
  PROBE(predicted("missed", "%"));
  PROBE(predicted("steps_for_nine_digits", "steps"));
}
