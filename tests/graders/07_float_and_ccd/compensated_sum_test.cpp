// Grader of 07.compensated_sum: sums that are known because their terms were made to cancel, or
// because they are whole multiples of a power of two and were added as whole numbers.

#include "carom/precision/compensated_sum.hpp"

#include <cmath>
#include <vector>

#include "carom/core/random.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kOnce = "the exact sum, rounded once, is half a step away at most";
constexpr Real kStep = 2.3e-16;  // one step of a double, relative to it

struct Sum {
  std::vector<Real> terms;
  Real exact = 0;
};

// Multiples of 1/16 up to a size, one to a line: whole numbers add up without error.
Sum multiples(Random& random, int count) {
  Sum sum;
  std::int64_t sixteenths = 0;
  for (int i = 0; i < count; ++i) {
    const std::int64_t m = random.integer(-1000, 1000) * (std::int64_t{1} << random.integer(0, 48));
    sixteenths += m;
    sum.terms.push_back(static_cast<Real>(m) / 16);
  }
  // What the low digits of a rounded sum would have hidden is asked for.
  const std::int64_t whole = sixteenths / 1024 * 1024;
  sum.terms.push_back(-static_cast<Real>(whole / 2) / 16);
  sum.terms.push_back(-static_cast<Real>(whole - whole / 2) / 16);
  sum.exact = static_cast<Real>(sixteenths - whole) / 16;
  return sum;
}

// Multiples of 1/8, and between them pairs of large numbers that cancel. What is lost on the way is
// below 2^41, so a double beside the sum holds it exactly.
Sum withLargePairs(Random& random) {
  Sum sum;
  for (int i = 0; i < 6; ++i) {
    const Real small = random.integer(1, 1000) / 8.0;
    const Real large = std::ldexp(random.between(1, 2), random.integer(60, 80));
    sum.exact += small;
    sum.terms.push_back(small);
    sum.terms.push_back(large);
    sum.terms.push_back(-large);
  }
  // The last pair apart, so that nothing may be taken off the term that happens to follow.
  sum.terms.insert(sum.terms.begin() + 1, 0x1.8p90);
  sum.terms.push_back(-0x1.8p90);
  return sum;
}

}  // namespace

TEST_CASE("tenths") {
  for (const int count : {10, 1000, 100000}) {
    const std::vector<Real> terms(static_cast<std::size_t>(count), 0.1);
    // The double 0.1 is too large by 5.55e-18: less than half a step of any of these sums.
    GRADE(compensatedSum(terms), count / 10.0, withinRelative(kStep, kOnce),
          given("number of terms", count), given("each", 0.1), unit("s"),
          about("steps of a tenth of a second, added up"));
  }
}

TEST_CASE("mixed") {
  Random random(seed());
  for (int n = 0; n < 6; ++n) {
    const Sum sum = multiples(random, 200 << n);
    GRADE(compensatedSum(sum.terms), sum.exact, within(1e-9, "a multiple of 1/16, exactly"),
          given("number of terms", sum.terms.size()), given("terms", sum.terms),
          about("terms between 1/16 and 10^16 in size, which nearly cancel"));
  }
}

TEST_CASE("larger") {
  const std::vector<Real> four = {1, 1e100, 1, -1e100};
  GRADE(compensatedSum(four), 2, within(0, "exactly"), given("terms", four));
  Random random(seed() + 1);
  for (int n = 0; n < 8; ++n) {
    const Sum sum = withLargePairs(random);
    GRADE(compensatedSum(sum.terms), sum.exact, withinRelative(kStep, kOnce),
          given("terms", sum.terms), about("small numbers, and pairs of large ones that cancel"));
  }
}

TEST_CASE("empty") {
  const std::vector<Real> none, one = {0.3};
  GRADE(compensatedSum(none), 0, within(0, "exactly"), about("no terms"));
  GRADE(compensatedSum(one), 0.3, within(0, "exactly"), given("terms", one));
}

PROBES() {
  Random random(702);
  for (int n = 0; n < 8; ++n) {
    PROBE(compensatedSum(multiples(random, 60).terms));
    PROBE(compensatedSum(withLargePairs(random).terms));
    std::vector<Real> terms = {1};  // Kahan's sum differs from the one of one branch here
    terms.push_back(std::ldexp(random.between(1, 2), 60));
    terms.push_back(1);
    terms.push_back(-terms[1]);
    PROBE(compensatedSum(terms));
  }
}
