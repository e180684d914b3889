// Grader of 03.ball_ball: triangles with whole sides, whose roots are exact, and radii that are
// rounded roots, where only the squares can tell.

#include "carom/detection/ball_ball.hpp"

#include <cmath>
#include <limits>

#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "these numbers are exact";
constexpr const char* kYesNo = "one of three words";

// Whole numbers whose root is not one, rounded so that the square of the rounded root still shows
// on which side of the number it lies.
struct RootPair {
  Vector3 center;
  Real radius = 0;
  const char* verdict = "";
};

std::vector<RootPair> rootPairs() {
  std::vector<RootPair> pairs;
  for (int x = 1; x <= 6; ++x) {
    for (int y = 0; y <= x; ++y) {
      for (int z = 0; z <= y; ++z) {
        const Real squared = x * x + y * y + z * z;
        const Real root = std::sqrt(squared);
        if (root * root == squared) continue;
        pairs.push_back(
            {Vector3(x, y, z), root, root * root < squared ? "separated" : "overlapping"});
      }
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("separation") {
  struct Case {
    Vector3 b;
    Real radiusA, radiusB, separation;
  };
  const Case cases[] = {{{3, 4, 0}, 2, 2, 1},     {{3, 4, 0}, 2, 3, 0},  {{3, 4, 0}, 3, 3, -1},
                        {{1, 2, 2}, 1, 0.5, 1.5}, {{2, 3, 6}, 4, 5, -2}, {{0, 0, 0}, 1, 2, -3},
                        {{-12, 0, 5}, 0, 0, 13}};
  for (const Case& c : cases) {
    GRADE(ballBall({0, 0, 0}, c.radiusA, c.b, c.radiusB).separation, c.separation,
          within(0, kExact), given("centre of B", c.b, "m"), given("radius of A", c.radiusA, "m"),
          given("radius of B", c.radiusB, "m"), unit("m"), about("A is at the origin"));
  }
  Random random(seed());
  for (int n = 0; n < 10; ++n) {
    // The distance is chosen first: B is placed along a direction.
    const Vector3 a = random.vector(5);
    const Vector3 direction = random.direction();
    const Real radiusA = random.between(0, 2), radiusB = random.between(0, 2);
    const Real separation = random.between(-1, 3);
    const Vector3 b = a + (radiusA + radiusB + separation) * direction;
    if (radiusA + radiusB + separation < 0) continue;
    GRADE(ballBall(a, radiusA, b, radiusB).separation, separation,
          within(2e-14, "a few roundings of coordinates of this size"),
          given("centre of A", a, "m"), given("centre of B", b, "m"),
          given("radius of A", radiusA, "m"), given("radius of B", radiusB, "m"), unit("m"));
  }
}

TEST_CASE("verdict") {
  struct Case {
    Vector3 b;
    Real radiusA, radiusB;
    const char* verdict;
  };
  const Case cases[] = {{{3, 4, 0}, 3, 3, "overlapping"}, {{3, 4, 0}, 2, 3, "touching"},
                        {{3, 4, 0}, 2, 2, "separated"},   {{2, 3, 6}, 3, 4, "touching"},
                        {{2, 3, 6}, 3, 3, "separated"},   {{1, 4, 8}, 5, 5, "overlapping"},
                        {{0, 0, 0}, 1, 2, "overlapping"}, {{1, 2, 2}, 3, 0, "touching"}};
  for (const Real scale : {1.0, 1024.0, 1.0 / 1048576}) {
    for (const Case& c : cases) {
      const Vector3 b = scale * c.b;
      GRADE(inWords(ballBall({0, 0, 0}, scale * c.radiusA, b, scale * c.radiusB).verdict),
            c.verdict, within(0, kYesNo), given("centre of B", b, "m"),
            given("radius of A", scale * c.radiusA, "m"),
            given("radius of B", scale * c.radiusB, "m"), about("A is at the origin"));
    }
  }
}

TEST_CASE("roots") {
  for (const RootPair& pair : rootPairs()) {
    GRADE(inWords(ballBall({0, 0, 0}, pair.radius / 2, pair.center, pair.radius / 2).verdict),
          pair.verdict, within(0, kYesNo), given("centre of B", pair.center, "m"),
          given("both radii", pair.radius / 2, "m"), given("their sum", pair.radius, "m"),
          given("|d|^2", pair.center.squaredNorm(), "m^2"),
          given("sum of the radii, squared", pair.radius * pair.radius, "m^2"),
          about("A is at the origin; the last digit of the squares decides"));
  }
}

TEST_CASE("refuses") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(ballBall({0, 0, 0}, -1, {1, 0, 0}, 1), given("radius of A", -1.0, "m"));
  GRADE_REFUSES(ballBall({0, nan, 0}, 1, {1, 0, 0}, 1),
                given("centre of A", Vector3(0, nan, 0), "m"));
}

PROBES() {
  Random random(301);
  for (int n = 0; n < 12; ++n) {
    const Vector3 a = random.vector(2);
    const Real radiusA = random.between(0.5, 1.5), radiusB = random.between(0.5, 1.5);
    PROBE(ballBall(a, radiusA, random.vector(2), radiusB));
  }
  const std::vector<RootPair> pairs = rootPairs();
  for (std::size_t n = 0; n < pairs.size() && n < 8; ++n) {
    PROBE(ballBall({0, 0, 0}, pairs[n].radius / 2, pairs[n].center, pairs[n].radius / 2));
  }
}
