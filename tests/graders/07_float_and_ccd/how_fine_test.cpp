// Grader of 07.how_fine: the loops are run, in floats and doubles.

#include <cmath>

#include "carom/precision/ulp.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kMargin = "a prediction may be 5% off";

// Whether a sum of floats is more than its first term, as a float.
bool adds(float x, float by) {
  volatile float sum = x + by;
  return sum > x;
}

// The least speed with which a body at x moves, found by halving.
Real slowestSpeed(float x) {
  float still = 0, moves = 100;
  for (int i = 0; i < 40; ++i) {
    const float middle = (still + moves) / 2;
    (adds(x, middle / 60) ? moves : still) = middle;
  }
  return moves;
}

Real clockStandsAt() {
  float t = 1;
  while (adds(t, 1 / 60.0f)) t *= 2;  // the step of a clock changes at powers of two
  return t;
}

Real stepsToTen() {
  int steps = 0;
  for (Real t = 0; t < 10; t += 0.1) ++steps;
  return steps;
}

}  // namespace

TEST_CASE("float") {
  GRADE(predicted("step_of_float", "m"), Real(ulp(1e6f)), withinRelative(0.05, kMargin), unit("m"),
        about("from 1000 km to the next float"));
}

TEST_CASE("double") {
  GRADE(predicted("step_of_double", "m"), ulp(1e6), withinRelative(0.05, kMargin), unit("m"),
        about("from 1000 km to the next double"));
}

TEST_CASE("slowest") {
  GRADE(predicted("slowest_speed", "m/s"), slowestSpeed(131072), withinRelative(0.05, kMargin),
        unit("m/s"), about("at 131 072 m, in floats: the slowest body that moves"));
}

TEST_CASE("clock") {
  GRADE(predicted("clock_stands_at", "s"), clockStandsAt(), withinRelative(0.05, kMargin),
        unit("s"), about("when the clock of floats stands still"));
}

TEST_CASE("steps") {
  GRADE(predicted("steps_to_ten", "steps"), stepsToTen(), within(0.5, "a number of steps is whole"),
        unit("steps"), about("how often the loop runs"));
}

PROBES() {
  PROBE(predicted("step_of_float", "m"));
  PROBE(predicted("step_of_double", "m"));
  PROBE(predicted("slowest_speed", "m/s"));
  PROBE(predicted("clock_stands_at", "s"));
  PROBE(predicted("steps_to_ten", "steps"));
}
