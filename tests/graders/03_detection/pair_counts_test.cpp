// Grader of 03.pair_counts: rows of boxes whose pairs can be counted on paper, and the slope of the
// work against the number of boxes.

#include "pair_counts.hpp"

#include <cmath>

#include "grading/grade.hpp"
#include "pair_counts_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kCount = "a count";

using Scene = std::vector<Aabb<3>>;
using Counts = std::vector<int>;

// Boxes in a row along x, each beginning `step` after the one before.
Scene rowOfBoxes(int n, Real step, Real size) {
  Scene scene;
  for (int k = 0; k < n; ++k) {
    scene.push_back({Vector3(step * k, 0, 0), Vector3(step * k + size, 1, 1)});
  }
  return scene;
}

// Boxes anywhere in a hall.
Scene hall(Random& random, int n) {
  Scene scene;
  for (int k = 0; k < n; ++k) {
    const Vector3 low = random.vector(4);
    Vector3 size;
    for (int i = 2; i >= 0; --i) size[i] = random.between(1, 3);
    scene.push_back({low, low + size});
  }
  return scene;
}

// The row with a number, or one that nothing agrees with if there is none.
PairCount row(const std::vector<PairCount>& table, std::size_t number) {
  return number < table.size() ? table[number] : PairCount{-1, -1, -1};
}

Real slopeOfAsked(const std::vector<PairCount>& table) {
  const PairCount first = row(table, 0), last = row(table, table.empty() ? 0 : table.size() - 1);
  return std::log(Real(last.asked) / first.asked) / std::log(Real(last.boxes) / first.boxes);
}

}  // namespace

TEST_CASE("asked") {
  const Scene boxes = rowOfBoxes(60, 2, 1);
  const Counts counts = {2, 3, 10, 60};
  const int pairs[] = {1, 3, 45, 1770};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    GRADE(row(pairCounts(boxes, counts), k).asked, pairs[k], within(0, kCount),
          given("boxes", "60 in a row, none of which meet"), given("counts", counts), given("k", k),
          about("row k, of the first counts[k] boxes: each pair once, and no box with itself"));
  }
  const Counts one = {1};
  GRADE(row(pairCounts(boxes, one), 0).asked, 0, within(0, kCount), given("one", one),
        about("a single box makes no pair"));
}

TEST_CASE("kept") {
  // Every box meets the next one in a side, and the next but one not at all.
  const Scene boxes = rowOfBoxes(40, 1, 1);
  const Counts counts = {5, 40};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    GRADE(row(pairCounts(boxes, counts), k).kept, counts[k] - 1, within(0, kCount),
          given("boxes", "40 in a row, each touching the next"), given("counts", counts),
          given("k", k), about("row k, of the first counts[k] boxes: pairs that touch are kept"));
  }
  // Every box reaches over the next two: n - 1 pairs of neighbours and n - 2 of next but one.
  const Scene overlapping = rowOfBoxes(40, 1, 2.5);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    GRADE(row(pairCounts(overlapping, counts), k).kept, 2 * counts[k] - 3, within(0, kCount),
          given("overlapping", "40 boxes in a row, each reaching over the next two"),
          given("counts", counts), given("k", k));
  }
}

TEST_CASE("rows") {
  const Scene scene = rowOfBoxes(30, 2, 1);
  const Counts counts = {30, 4, 12};
  GRADE(pairCounts(scene, counts).size(), std::size_t{3}, within(0, kCount),
        given("counts", counts), about("one row for each count"));
  for (std::size_t k = 0; k < counts.size(); ++k) {
    GRADE(row(pairCounts(scene, counts), k).boxes, counts[k], within(0, "a copy"),
          given("counts", counts), given("row", k));
  }
}

TEST_CASE("slope") {
  Random random(seed());
  const Scene scene = hall(random, 320);
  const Counts counts = {160, 320};
  GRADE(slopeOfAsked(pairCounts(scene, counts)), 2, within(0.01, "n (n - 1) is nearly n squared"),
        given("counts", counts),
        about("slope of the pairs asked, with both axes logarithmic: 2 for a square"));
}

TEST_CASE("refuses") {
  const Scene scene = rowOfBoxes(3, 2, 1);
  const Counts tooMany = {4};
  GRADE_REFUSES(pairCounts(scene, tooMany), given("counts", tooMany),
                about("more boxes than the scene has"));
}

PROBES() {
  Random random(312);
  for (int n = 0; n < 16; ++n) {
    const Scene scene = hall(random, 24);
    const Counts counts = {12 + n % 5, 24};
    PROBE(row(pairCounts(scene, counts), n % 2));
  }
  PROBE(row(pairCounts(rowOfBoxes(40, 1, 1), Counts{40}), 0));
}
