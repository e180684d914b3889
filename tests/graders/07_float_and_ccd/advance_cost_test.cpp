// Grader of 07.advance_cost: each step leaves a share of 1 - 1/caution of the gap, so the number of
// steps can be written down.

#include "advance_cost.hpp"

#include <cmath>
#include <limits>

#include "advance_cost_fields.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Reals = std::vector<Real>;

// A row, or one of no numbers where there is none.
Real stepsIn(const std::vector<AdvanceCost>& table, std::size_t k) {
  return k < table.size() ? table[k].steps : std::numeric_limits<Real>::quiet_NaN();
}

Reals tolerancesIn(const std::vector<AdvanceCost>& table) {
  Reals all;
  for (const AdvanceCost& row : table) all.push_back(row.tolerance);
  return all;
}

// How many steps each digit takes, from the first two rows.
Real stepsPerDigit(Real caution, Real coarse, Real fine) {
  const std::vector<AdvanceCost> table = advanceCost(caution, Reals{coarse, fine});
  return (stepsIn(table, 1) - stepsIn(table, 0)) / std::log10(coarse / fine);
}

void askSteps(Real caution, const Reals& tolerances, std::size_t k, const char* what) {
  GRADE(stepsIn(advanceCost(caution, tolerances), k),
        std::ceil(std::log(tolerances[k]) / std::log1p(-1 / caution)),
        within(0, "a number of steps is whole"), given("caution", caution),
        given("tolerances", tolerances, "m"), about(what));
}

// Such that the search comes well within it, and not just.
Real toleranceAfter(Real caution, int steps) {
  return std::pow(1 - 1 / caution, steps - 0.5);
}

}  // namespace

TEST_CASE("table") {
  const Reals tolerances = {1e-3, 1e-9, 0.1};
  GRADE(tolerancesIn(advanceCost(2, tolerances)), tolerances,
        within(0, "the tolerances as they were given"), given("caution", 2.0),
        given("tolerances", tolerances, "m"), unit("m"), about("the column tolerance"));
  askSteps(2, tolerances, 0, "steps in the first row: halves until 1 mm");
  askSteps(2, tolerances, 1, "steps in the second row: halves until 1 nm");
  askSteps(2, tolerances, 2, "steps in the third row: halves until 10 cm");
}

TEST_CASE("digits") {
  GRADE(stepsPerDigit(2, 1e-2, 1e-12), std::log(10) / std::log(2), within(0.15, "whole steps"),
        given("caution", 2.0), given("tolerances", Reals{1e-2, 1e-12}, "m"),
        about("steps per digit: 1 / log10(2)"));
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Real caution = random.between(1.3, 12);
    GRADE(stepsPerDigit(caution, 1e-2, 1e-12), std::log(10) / -std::log1p(-1 / caution),
          within(0.15, "whole steps"), given("caution", caution),
          given("tolerances", Reals{1e-2, 1e-12}, "m"),
          about("steps per digit: 1 / log10(c / (c - 1))"));
    askSteps(caution, {toleranceAfter(caution, random.integer(5, 15))}, 0, "steps");
  }
  GRADE(stepsIn(advanceCost(1, Reals{1e-9}), 0), 1, within(0, "a number of steps is whole"),
        given("caution", 1.0), given("tolerances", Reals{1e-9}, "m"),
        about("steps, if the bound is the very speed"));
}

TEST_CASE("cautious") {
  Random random(seed() + 1);
  for (int n = 0; n < 3; ++n) {
    const Real caution = random.between(200, 600);
    askSteps(caution, {toleranceAfter(caution, random.integer(2000, 4000))}, 0,
             "steps, with a bound hundreds of times too large");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(advanceCost(0.5, Reals{1e-3}), given("caution", 0.5));
}

PROBES() {
  Random random(713);
  for (int n = 0; n < 12; ++n) {
    const Reals tolerances = {random.between(0.01, 0.1), random.between(1e-6, 1e-5)};
    PROBE(advanceCost(random.between(1.5, 20), tolerances));
  }
  PROBE(advanceCost(400, Reals{1e-2, 1e-3}));
}
