// Grader of 03.box_distance: boxes that are put beside each other with gaps and overlaps of known
// width, so that the distance follows from the gaps alone.

#include "box_distance.hpp"

#include <cmath>
#include <limits>

#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "these numbers are exact";
constexpr const char* kRounding = "a few roundings of coordinates of this size";

struct Pair {
  Aabb<3> a, b;
  Real distance = 0;
};

// On each axis B begins `gap` after the end of A, or ends as much before A begins; a negative gap
// is an overlap.
Pair pairWith(Random& random, const Vector3& gaps) {
  Pair pair;
  Real squares = 0;
  for (int i = 0; i < 3; ++i) {
    pair.a.low(i) = random.between(-4, 4);
    pair.a.high(i) = pair.a.low(i) + random.between(1.5, 3);
    const Real size = random.between(1.5, 3);
    if (random.integer(0, 1)) {
      pair.b.low(i) = pair.a.high(i) + gaps(i);
      pair.b.high(i) = pair.b.low(i) + size;
    } else {
      pair.b.high(i) = pair.a.low(i) - gaps(i);
      pair.b.low(i) = pair.b.high(i) - size;
    }
    if (gaps(i) > 0) squares += gaps(i) * gaps(i);
  }
  pair.distance = std::sqrt(squares);
  return pair;
}

Vector3 anyGaps(Random& random) {
  return {random.between(-1.2, 3), random.between(-1.2, 3), random.between(-1.2, 3)};
}

const Aabb<3> cube{{-1, -1, -1}, {1, 1, 1}};

void ask(const Vector3& low, const Vector3& high, Real distance, const char* what) {
  const Aabb<3> other{low, high};
  for (const bool swapped : {false, true}) {
    const Aabb<3>& a = swapped ? other : cube;
    const Aabb<3>& b = swapped ? cube : other;
    GRADE(boxDistance(a, b), distance, within(0, kExact), given("a", a, "m"), given("b", b, "m"),
          unit("m"), about(what));
  }
}

}  // namespace

TEST_CASE("beside") {
  ask({3, -1, -1}, {5, 1, 1}, 2, "side by side, with a gap of 2 m along x");
  ask({-0.5, -0.5, -7}, {0.5, 0.5, -4}, 3, "one 3 m below the other");
}

TEST_CASE("corners") {
  ask({4, 5, -0.5}, {6, 6, 0.5}, 5, "gaps of 3 m and 4 m, and the same height");
  ask({-9, -3, 3}, {-2, -2, 4}, std::sqrt(6.0), "corner to corner: gaps of 1 m, 1 m and 2 m");
}

TEST_CASE("meeting") {
  ask({0.5, -1, -1}, {3, 1, 1}, 0, "they overlap by 0.5 m: there is no way to go");
  ask({1, -1, -1}, {3, 1, 1}, 0, "they touch");
  ask({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 0, "one inside the other");
  ask({1.25, -1, -1}, {3, 1, 1}, 0.25, "nearly touching");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Pair pair = pairWith(random, anyGaps(random));
    GRADE(boxDistance(pair.a, pair.b), pair.distance, within(1e-14, kRounding),
          given("a", pair.a, "m"), given("b", pair.b, "m"), unit("m"));
  }
}

TEST_CASE("refuses") {
  const Aabb<3> bad{{0, std::numeric_limits<Real>::quiet_NaN(), 0}, {1, 1, 1}};
  GRADE_REFUSES(boxDistance(bad, cube), given("a", bad, "m"));
}

PROBES() {
  Random random(311);
  for (int n = 0; n < 24; ++n) {
    const Pair pair = pairWith(random, anyGaps(random));
    PROBE(boxDistance(pair.a, pair.b));
  }
}
