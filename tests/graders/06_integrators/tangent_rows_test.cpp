// Grader of 06.tangent_rows: the tangent itself, and how many rows there are.

#include "tangent_rows.hpp"

#include <cmath>
#include <limits>

#include "grading/grade.hpp"
#include "grading/random.hpp"
#include "tangent_rows_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kMethod = "the method's own error";

// A row, or one of no numbers where there is none.
TangentRow row(const std::vector<TangentRow>& rows, std::size_t k) {
  const Real none = std::numeric_limits<Real>::quiet_NaN();
  return k < rows.size() ? rows[k] : TangentRow{none, none};
}
TangentRow lastOf(const std::vector<TangentRow>& rows) {
  return row(rows, rows.size() - 1);
}

std::vector<TangentRow> exact(Real end, int steps) {
  std::vector<TangentRow> rows;
  for (int i = 0; i <= steps; ++i) {
    const Real x = end * i / steps;
    rows.push_back({x, std::tan(x)});
  }
  return rows;
}

}  // namespace

TEST_CASE("first") {
  GRADE(row(tangentRows(1, 10), 0), TangentRow({0, 0}), within(0, "no step has been made"),
        given("end", 1.0, "rad"), given("steps", 10), about("the first row"));
  GRADE(row(tangentRows(1, 10), 1), TangentRow({0.1, std::tan(0.1)}), within(1e-6, kMethod),
        given("end", 1.0, "rad"), given("steps", 10), about("the second row"));
}

TEST_CASE("last") {
  GRADE(lastOf(tangentRows(1, 10)), TangentRow({1, std::tan(1)}), within(1e-5, kMethod),
        given("end", 1.0, "rad"), given("steps", 10), about("the last row"));
  Random random(seed());
  for (int n = 0; n < 6; ++n) {
    const Real end = random.between(0.3, 1.2);
    const int steps = random.integer(20, 60);
    GRADE(lastOf(tangentRows(end, steps)), TangentRow({end, std::tan(end)}), within(1e-4, kMethod),
          given("end", end, "rad"), given("steps", steps), about("the last row"));
  }
}

TEST_CASE("rows") {
  GRADE(tangentRows(1, 4), exact(1, 4), within(1e-3, kMethod), given("end", 1.0, "rad"),
        given("steps", 4), about("the whole table"));
  // Added up, twenty times 0.05 is more than 1, and ten times 0.12 more than 1.2.
  GRADE(tangentRows(1, 20), exact(1, 20), within(1e-5, kMethod), given("end", 1.0, "rad"),
        given("steps", 20), about("the whole table"));
  GRADE(tangentRows(1.2, 10), exact(1.2, 10), within(1e-3, kMethod), given("end", 1.2, "rad"),
        given("steps", 10), about("the whole table"));
  GRADE(tangentRows(0.7, 24).size(), 25u, within(0, "a number of rows"), given("end", 0.7, "rad"),
        given("steps", 24), about("how many rows"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(tangentRows(2, 10), given("end", 2.0, "rad"));
  GRADE_REFUSES(tangentRows(1, 0), given("steps", 0));
}

PROBES() {
  Random random(613);
  PROBE(tangentRows(1, 20));
  PROBE(tangentRows(1.2, 10));
  for (int n = 0; n < 14; ++n) {
    const Real end = random.between(0.3, 1.2);
    PROBE(tangentRows(end, random.integer(3, 12)));
  }
}
