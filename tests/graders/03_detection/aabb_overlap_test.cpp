// Grader of 03.aabb_overlap: boxes with whole corners, judged by counting: they overlap if they
// share a cell of the grid, and touch if they only share points of it.

#include "carom/detection/aabb_overlap.hpp"

#include <limits>

#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kYesNo = "one of three words";

Aabb<3> box(const Vector3& low, const Vector3& high) {
  return {low, high};
}

// How many whole numbers, and how many unit steps, two ranges have in common.
int commonNumbers(int low1, int high1, int low2, int high2) {
  int count = 0;
  for (int k = low1; k <= high1; ++k) count += k >= low2 && k <= high2;
  return count;
}
int commonSteps(int low1, int high1, int low2, int high2) {
  int count = 0;
  for (int k = low1; k < high1; ++k) count += k >= low2 && k < high2;
  return count;
}

struct WholeBox {
  int low[3], high[3];
  Aabb<3> real() const {
    return {Vector3(low[0], low[1], low[2]), Vector3(high[0], high[1], high[2])};
  }
};

WholeBox wholeBox(Random& random) {
  WholeBox b{};
  for (int i = 0; i < 3; ++i) {
    b.low[i] = random.integer(-4, 3);
    b.high[i] = b.low[i] + random.integer(1, 4);
  }
  return b;
}

const char* byCounting(const WholeBox& a, const WholeBox& b) {
  int numbers = 1, steps = 1;
  for (int i = 0; i < 3; ++i) {
    numbers *= commonNumbers(a.low[i], a.high[i], b.low[i], b.high[i]);
    steps *= commonSteps(a.low[i], a.high[i], b.low[i], b.high[i]);
  }
  if (steps > 0) return "overlapping";
  return numbers > 0 ? "touching" : "separated";
}

void ask(const Aabb<3>& a, const Aabb<3>& b, const char* verdict, const char* what) {
  GRADE(inWords(aabbOverlap(a, b)), verdict, within(0, kYesNo), given("a", a, "m"),
        given("b", b, "m"), about(what));
  GRADE(inWords(aabbOverlap(b, a)), verdict, within(0, kYesNo), given("a", b, "m"),
        given("b", a, "m"), about(what));
}

}  // namespace

TEST_CASE("apart") {
  const Aabb<3> a = box({0, 0, 0}, {2, 2, 2});
  ask(a, box({1, 1, 1}, {3, 3, 3}), "overlapping", "a common corner");
  ask(a, box({3, 0, 0}, {4, 2, 2}), "separated", "side by side with a gap along x");
  ask(a, box({0.5, 5, 0.5}, {1, 6, 1}), "separated", "one above the other with a gap along y");
  ask(a, box({0, 0, -3}, {2, 2, -2.5}), "separated", "with a gap along z only");
  ask(a, box({5, 5, 5}, {6, 6, 6}), "separated", "with a gap along every axis");
}

TEST_CASE("touching") {
  const Aabb<3> a = box({0, 0, 0}, {1, 1, 1});
  ask(a, box({1, 0, 0}, {2, 1, 1}), "touching", "a common side");
  ask(a, box({1, 1, 0}, {2, 2, 1}), "touching", "a common edge");
  ask(a, box({1, 1, 1}, {2, 2, 2}), "touching", "a common corner");
  ask(a, box({1, 5, 0}, {2, 6, 1}), "separated",
      "the same x where they would meet, but 4 m apart in y");
  ask(a, box({1, 0, 1.5}, {2, 1, 3}), "separated",
      "the same x where they would meet, but apart in z");
}

TEST_CASE("inside") {
  ask(box({0, 0, 0}, {10, 10, 10}), box({4, 4, 4}, {5, 5, 5}), "overlapping", "one wholly inside");
  ask(box({-5, -1, -1}, {5, 1, 1}), box({-1, -5, -0.5}, {1, 5, 0.5}), "overlapping",
      "a cross: no corner of one is inside the other");
  ask(box({1, 2, 3}, {4, 5, 6}), box({1, 2, 3}, {4, 5, 6}), "overlapping", "the same box twice");
}

TEST_CASE("grid") {
  Random random(seed());
  for (int n = 0; n < 60; ++n) {
    const WholeBox a = wholeBox(random), b = wholeBox(random);
    GRADE(inWords(aabbOverlap(a.real(), b.real())), byCounting(a, b), within(0, kYesNo),
          given("a", a.real(), "m"), given("b", b.real(), "m"));
  }
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(aabbOverlap(box({0, nan, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})),
                given("low corner of a", Vector3(0, nan, 0), "m"));
}

PROBES() {
  Random random(303);
  for (int n = 0; n < 28; ++n) {
    const WholeBox b = wholeBox(random), a = wholeBox(random);
    PROBE(aabbOverlap(a.real(), b.real()));
  }
  // Touching on one axis, on two, and on none while apart elsewhere.
  const Aabb<3> a = box({0, 0, 0}, {2, 2, 2});
  PROBE(aabbOverlap(a, box({2, 1, 1}, {3, 3, 3})));
  PROBE(aabbOverlap(a, box({2, 5, 1}, {3, 6, 3})));
  PROBE(aabbOverlap(box({-5, -1, -1}, {5, 1, 1}), box({-1, -5, -0.5}, {1, 5, 0.5})));
  PROBE(aabbOverlap(a, box({0, 0, 5}, {2, 2, 6})));
}
