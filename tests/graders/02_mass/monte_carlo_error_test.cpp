// Grader of 02.monte_carlo_error: one dart at a time can be worked out on paper, and the table for
// many darts must have the slope and the size that a binomial spread has.

#include "monte_carlo_error.hpp"

#include <array>
#include <cmath>

#include "carom/mass/meshes.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "grading/grade.hpp"
#include "monte_carlo_error_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

// The corner of a box: a share of exactly 1/6 of the darts hits it.
TriangleMesh cornerOfBox(const Vector3& edges) {
  return tetrahedronMesh({0, 0, 0}, {edges.x(), 0, 0}, {0, edges.y(), 0}, {0, 0, edges.z()});
}

// One dart: the estimate is the whole box (six times too much, error 5) or nothing (error -1).
Real errorOfSingleDarts(const TriangleMesh& mesh, int seeds) {
  int hits = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    hits += monteCarloMass(mesh, 1, 1, static_cast<std::uint64_t>(seed)).inside;
  }
  return std::sqrt(static_cast<Real>(25 * hits + (seeds - hits)) / seeds);
}

std::vector<int> counts(const std::vector<DartError>& table) {
  std::vector<int> all;
  for (const DartError& row : table) all.push_back(row.samples);
  return all;
}

// The slope of a straight line through the logarithms, by least squares.
Real slope(const std::vector<DartError>& table) {
  const Real n = static_cast<Real>(table.size());
  Real x = 0, y = 0, xx = 0, xy = 0;
  for (const DartError& row : table) {
    const Real u = std::log(Real(row.samples));
    const Real v = std::log(row.relativeError);
    x += u / n;
    y += v / n;
    xx += u * u / n;
    xy += u * v / n;
  }
  return (xy - x * y) / (xx - x * x);
}

Real errorInRow(const std::vector<DartError>& table, std::size_t row) {
  return row < table.size() ? table[row].relativeError : -1;
}

constexpr int kSeeds = 64;
constexpr std::array<int, 5> kDarts = {32, 128, 512, 2048, 8192};
constexpr const char* kSpread =
    "with 64 seeds each error is itself uncertain by one part in eleven; this is five times that";

}  // namespace

TEST_CASE("one_dart") {
  const TriangleMesh mesh = cornerOfBox({2, 3, 1});
  const std::array<int, 1> one = {1};
  for (const int seeds : {3, 10, 40}) {
    const Real expected = errorOfSingleDarts(mesh, seeds);
    GRADE(errorInRow(monteCarloError(mesh, one, seeds), 0), expected,
          withinRelative(1e-13, "whole numbers and one root"),
          given("mesh", "a tetrahedron that fills one sixth of its box"),
          given("sampleCounts", one), given("seeds", seeds),
          about("a hit estimates six times the volume (error 5), a miss none (error -1)"));
  }
}

TEST_CASE("table") {
  const TriangleMesh mesh = cornerOfBox({1, 1, 1});
  const std::array<int, 3> darts = {500, 2, 40};
  GRADE(counts(monteCarloError(mesh, darts, 2)), (std::vector<int>{500, 2, 40}),
        within(0, "the numbers of darts as they were asked for"), given("sampleCounts", darts),
        given("seeds", 2));
  // 6 hits/N - 1 for two darts and one seed is -1, 2 or 5.
  const int hits = monteCarloMass(mesh, 1, 2, 1).inside;
  GRADE(errorInRow(monteCarloError(mesh, darts, 1), 1), std::abs(3.0 * hits - 1),
        within(1e-14, "whole numbers"),
        given("mesh", "a tetrahedron that fills one sixth of its box"),
        given("sampleCounts", darts), given("seeds", 1), about("the row for 2 darts"));
}

TEST_CASE("slope") {
  GRADE(slope(monteCarloError(cornerOfBox({1, 2, 2}), kDarts, kSeeds)), -0.5,
        within(0.12, "five times the spread of a slope through five points of 64 seeds"),
        given("mesh", "a tetrahedron that fills one sixth of its box"),
        given("sampleCounts", kDarts), given("seeds", kSeeds),
        about("the slope of your errors against the number of darts, both as logarithms"));
  GRADE(slope(monteCarloError(icosphereMesh(1, 1), kDarts, kSeeds)), -0.5,
        within(0.12, "five times the spread of a slope through five points of 64 seeds"),
        given("mesh", "a ball of 80 triangles"), given("sampleCounts", kDarts),
        given("seeds", kSeeds),
        about("the slope of your errors against the number of darts, both as logarithms"));
}

TEST_CASE("size") {
  // A share of 1/6 hits: sqrt((1-p)/(pN)) = sqrt(5/N).
  for (const Real size : {0.1, 5.0}) {
    const TriangleMesh mesh = cornerOfBox({size, size, 2 * size});
    for (const int darts : {200, 3200}) {
      const std::array<int, 1> count = {darts};
      GRADE(errorInRow(monteCarloError(mesh, count, kSeeds), 0), std::sqrt(5.0 / darts),
            withinRelative(0.45, kSpread),
            given("mesh", "a tetrahedron that fills one sixth of its box"),
            given("its size", size, "m"), given("sampleCounts", count), given("seeds", kSeeds));
    }
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(monteCarloError(cornerOfBox({1, 1, 1}), kDarts, 0), given("seeds", 0));
}

PROBES() {
  Random random(31);
  for (int n = 0; n < 16; ++n) {
    const Vector3 edges = Vector3(1.5, 1.5, 1.5) + random.vector();
    const std::array<int, 2> darts = {random.integer(5, 40), random.integer(41, 90)};
    PROBE(monteCarloError(cornerOfBox(edges), darts, 3));
  }
}
