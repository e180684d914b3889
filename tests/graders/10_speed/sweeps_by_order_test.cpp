// Grader of 10.sweeps_by_order: the same sweeps over impulses and a matrix, without any speeds.

#include "sweeps_by_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "box_pyramid.hpp"
#include "grading/grade.hpp"
#include "speed_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

using Heights = std::vector<int>;
using Reals = std::vector<Real>;

constexpr const char* kCount = "a count";

// How fast body `body` moves upwards after these impulses, and all other speeds of it.
Reals speedsOf(const BoxPyramid& p, const Reals& impulses) {
  Reals speeds(6 * p.centres.size(), 0);
  for (std::size_t i = 0; i < p.centres.size(); ++i) speeds[6 * i + 2] = -1;
  for (std::size_t r = 0; r < impulses.size(); ++r) {
    for (std::size_t k = 0; k < 6; ++k) {
      const PlainRow& row = p.rows[r];
      if (row.bodyA >= 0) {
        speeds[6 * static_cast<std::size_t>(row.bodyA) + k] += impulses[r] * row.changeA[k];
      }
      speeds[6 * static_cast<std::size_t>(row.bodyB) + k] += impulses[r] * row.changeB[k];
    }
  }
  return speeds;
}

// Sweeps over x >= 0, A x + b >= 0, where b is -1 between box and ground and 0 between boxes.
int sweepsOf(int height, bool byColor) {
  const BoxPyramid p = boxPyramid(height);
  const std::size_t n = p.rows.size();
  const std::vector<std::int32_t> colors =
      colorGraph(p.contacts, static_cast<std::int32_t>(p.centres.size()));
  Reals matrix(n * n, 0), x(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const PlainRow &a = p.rows[i], &b = p.rows[j];
      for (std::size_t k = 0; k < 6; ++k) {
        if (a.bodyA >= 0 && a.bodyA == b.bodyA) matrix[i * n + j] += a.alongA[k] * b.changeA[k];
        if (a.bodyA >= 0 && a.bodyA == b.bodyB) matrix[i * n + j] += a.alongA[k] * b.changeB[k];
        if (a.bodyB == b.bodyA) matrix[i * n + j] += a.alongB[k] * b.changeA[k];
        if (a.bodyB == b.bodyB) matrix[i * n + j] += a.alongB[k] * b.changeB[k];
      }
    }
  }
  const std::int32_t greatest = *std::max_element(colors.begin(), colors.end());
  for (int sweeps = 1; sweeps < 100'000; ++sweeps) {
    for (std::int32_t color = 0; color <= (byColor ? greatest : 0); ++color) {
      for (std::size_t i = 0; i < n; ++i) {
        if (byColor && colors[i] != color) continue;
        Real parting = p.rows[i].bodyA < 0 ? -1 : 0;
        for (std::size_t j = 0; j < n; ++j) parting += matrix[i * n + j] * x[j];
        x[i] = std::max(Real(0), x[i] - parting / matrix[i * n + i]);
      }
    }
    Real fastest = 0;
    const Reals speeds = speedsOf(p, x);
    for (std::size_t k = 2; k < speeds.size(); k += 6) {
      fastest = std::max(fastest, std::abs(speeds[k]));
    }
    if (fastest <= 1e-3) return sweeps;
  }
  return -1;
}

std::vector<int> heightsIn(const std::vector<SweepsByOrder>& table) {
  std::vector<int> all;
  for (const SweepsByOrder& row : table) all.push_back(row.height);
  return all;
}

int upwardsIn(const Heights& heights, std::size_t k) {
  const std::vector<SweepsByOrder> table = sweepsByOrder(heights);
  return k < table.size() ? table[k].upwards : -1;
}

int byColorIn(const Heights& heights, std::size_t k) {
  const std::vector<SweepsByOrder> table = sweepsByOrder(heights);
  return k < table.size() ? table[k].byColor : -1;
}

// Twice the height: how many times the sweeps. Not a number where there are none.
Real growth(int height, bool byColor) {
  const std::vector<SweepsByOrder> table = sweepsByOrder(Heights{height, 2 * height});
  if (table.size() != 2) return std::numeric_limits<Real>::quiet_NaN();
  const Real few = byColor ? table[0].byColor : table[0].upwards;
  return (byColor ? table[1].byColor : table[1].upwards) / few;
}

}  // namespace

TEST_CASE("rows") {
  const Heights heights = {4, 2, 5};
  GRADE(heightsIn(sweepsByOrder(heights)), heights, within(0, "the heights as they were given"),
        given("heights", heights), about("the column height"));
  GRADE(upwardsIn(heights, 2), sweepsOf(5, false), within(0, kCount), given("heights", heights),
        about("the sweeps upwards of the third pyramid"));
  GRADE(byColorIn(heights, 2), sweepsOf(5, true), within(0, kCount), given("heights", heights),
        about("the sweeps by colour of the third pyramid"));
}

TEST_CASE("upwards") {
  Random random(seed());
  for (int n = 0; n < 3; ++n) {
    const Heights heights = {3, random.integer(4, 9)};
    GRADE(upwardsIn(heights, 1), sweepsOf(heights[1], false), within(0, kCount),
          given("heights", heights), about("the sweeps upwards of the second pyramid"));
  }
}

TEST_CASE("colors") {
  Random random(seed() + 1);
  for (int n = 0; n < 3; ++n) {
    const Heights heights = {3, random.integer(4, 9)};
    GRADE(byColorIn(heights, 1), sweepsOf(heights[1], true), within(0, kCount),
          given("heights", heights), about("the sweeps by colour of the second pyramid"));
  }
}

TEST_CASE("law") {
  for (const bool byColor : {false, true}) {
    GRADE(growth(10, byColor), 4, within(0.4, "the law holds for tall pyramids"),
          given("heights", Heights{10, 20}), given("by colour", byColor),
          about("how many times as many sweeps twice the height wants"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(heightsIn(sweepsByOrder(Heights{0})), given("heights", Heights{0}));
  GRADE_REFUSES(heightsIn(sweepsByOrder(Heights{31})), given("heights", Heights{31}));
}

PROBES() {
  for (int n = 2; n < 10; ++n) {
    PROBE(upwardsIn(Heights{n, n + 1}, 0));
    PROBE(upwardsIn(Heights{n, n + 2}, 1));
    PROBE(byColorIn(Heights{n, n + 1}, 1));
  }
}
