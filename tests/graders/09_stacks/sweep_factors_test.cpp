// Grader of 09.sweep_factors: the matrix of a tower has known eigenvalues.

#include "sweep_factors.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "grading/grade.hpp"
#include "sweep_factors_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Counts = std::vector<int>;

std::vector<int> boxesIn(const std::vector<SweepFactor>& table) {
  std::vector<int> all;
  for (const SweepFactor& row : table) all.push_back(row.boxes);
  return all;
}

Real factorIn(const std::vector<SweepFactor>& table, std::size_t k) {
  return k < table.size() ? table[k].factor : std::numeric_limits<Real>::quiet_NaN();
}

Real expected(int n) {
  const Real c = std::cos(std::numbers::pi / (2 * n));
  return c * c;
}

void askFactor(const Counts& counts, std::size_t k, const char* what) {
  GRADE(factorIn(sweepFactors(counts), k), expected(counts[k]),
        within(1e-6, "the quick parts of the error have died out"), given("counts", counts),
        about(what));
}

// How much less than 1 the factor of a tower is, beside one twice as tall.
Real ratioOfWhatIsTaken(int n) {
  const std::vector<SweepFactor> table = sweepFactors(Counts{n, 2 * n});
  return std::sqrt(std::log(factorIn(table, 0)) / std::log(factorIn(table, 1)));
}

}  // namespace

TEST_CASE("rows") {
  const Counts counts = {12, 4, 20};
  GRADE(boxesIn(sweepFactors(counts)), counts, within(0, "the counts as they were given"),
        given("counts", counts), about("the column boxes"));
  askFactor(counts, 1, "the factor of the second tower");
  askFactor(counts, 2, "the factor of the third tower");
}

TEST_CASE("factor") {
  Random random(seed());
  askFactor({2}, 0, "a tower of two");
  for (int n = 0; n < 3; ++n) {
    askFactor({random.integer(3, 30)}, 0, "the factor: cos^2(pi / 2n)");
  }
}

TEST_CASE("slope") {
  GRADE(ratioOfWhatIsTaken(20), 2, within(0.02, "the law holds for tall towers"),
        given("counts", Counts{20, 40}),
        about("log of the factor for 20 boxes over that for 40: the square root of the ratio"));
  GRADE(std::log(factorIn(sweepFactors(Counts{40}), 0)) * 40 * 40, -2.4687,
        within(0.01, "the law holds for tall towers"), given("counts", Counts{40}),
        about("log of the factor times n^2: -(pi/2)^2"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(sweepFactors(Counts{1}), given("counts", Counts{1}));
}

PROBES() {
  for (int n = 3; n < 19; ++n) {
    PROBE(factorIn(sweepFactors(Counts{n, n + 1}), 0));
    PROBE(factorIn(sweepFactors(Counts{n, n + 2}), 1));
  }
}
