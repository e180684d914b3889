// Grader of 07.ulp_distance: steps that were walked one by one, and powers of two, between which
// there are as many steps as the fraction has values.

#include "carom/precision/ulp_distance.hpp"

#include <cmath>
#include <limits>

#include "carom/core/random.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "steps are whole numbers";
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

Real walked(Real from, int steps) {
  for (int i = 0; i < steps; ++i) from = std::nextafter(from, kInfinity);
  return from;
}

// A number of any size up to 2^30, of either sign.
Real anyNumber(Random& random) {
  return std::ldexp(random.between(1.01, 1.9), random.integer(-30, 30)) *
         (random.integer(0, 1) ? 1 : -1);
}

}  // namespace

TEST_CASE("near") {
  Random random(seed());
  GRADE(ulpDistance(1000, walked(1000, 3)), std::uint64_t{3}, within(0, kExact),
        about("1000, and the number three steps above it"));
  for (int n = 0; n < 12; ++n) {
    const Real a = anyNumber(random);
    const int steps = random.integer(2, 40);
    const Real b = walked(a, steps);
    GRADE(ulpDistance(a, b), static_cast<std::uint64_t>(steps), within(0, kExact), given("a", a),
          given("b", b));
    GRADE(ulpDistance(b, a), static_cast<std::uint64_t>(steps), within(0, kExact), given("a", b),
          given("b", a));
  }
}

TEST_CASE("powers") {
  GRADE(ulpDistance(1, 2), std::uint64_t{1} << 52, within(0, kExact),
        about("from 1 to 2: one step for each fraction"));
  GRADE(ulpDistance(0.25, 4), std::uint64_t{1} << 54, within(0, kExact),
        about("from 1/4 to 4: four powers of two"));
  const Real below = std::nextafter(8, 0.0), above = walked(8, 5);
  GRADE(ulpDistance(below, above), std::uint64_t{6}, within(0, kExact), given("a", below),
        given("b", above), about("from one step below 8 to five above"));
  GRADE(ulpDistance(-64, -1), std::uint64_t{6} << 52, within(0, kExact),
        about("from -64 to -1: six powers of two"));
}

TEST_CASE("zero") {
  GRADE(ulpDistance(-5e-324, 5e-324), std::uint64_t{2}, within(0, kExact),
        about("5e-324 is the smallest double above zero"));
  const Real tiny = walked(0, 7);
  GRADE(ulpDistance(-tiny, walked(0, 4)), std::uint64_t{11}, within(0, kExact),
        about("from the seventh double below zero to the fourth above"));
  GRADE(ulpDistance(0.0, -0.0), std::uint64_t{0}, within(0, kExact), about("0 and -0 are equal"));
  GRADE(ulpDistance(-1, 1), std::uint64_t{2 * 1023} << 52, within(0, kExact),
        about("from -1 to 1: 1023 powers of two on either side, the subnormal numbers with them"));
  GRADE(ulpDistance(std::numeric_limits<Real>::max(), kInfinity), std::uint64_t{1},
        within(0, kExact), about("infinity is one step beyond the largest double"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(ulpDistance(std::nan(""), 1), given("a", std::nan("")));
}

PROBES() {
  Random random(701);
  for (int n = 0; n < 16; ++n) {
    const Real a = anyNumber(random);
    PROBE(ulpDistance(a, walked(a, random.integer(2, 40))));
    PROBE(ulpDistance(a, anyNumber(random)));
  }
  PROBE(ulpDistance(0.0, -0.0));
  PROBE(ulpDistance(1, 2));
}
