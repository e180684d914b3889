// Grader of 04.orient_normal: bodies on either side, a nail whose weight is in its head, and clouds
// that have been placed at a known end of each other.

#include "carom/manifold/orient_normal.hpp"

#include <cmath>

#include "graders/solids.hpp"
#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "the axis itself or its opposite, copied";

const Points cube = boxBetween({-1, -1, -1}, {1, 1, 1});

// A cloud whose shadow on a direction is exactly what is wanted: two points at the ends, the others
// between them.
Points between(Random& random, const Vector3& unit, Real low, Real high) {
  Points all;
  for (int k = 0; k < 6; ++k) {
    const Vector3 p = random.vector(3);
    Real along = low + (high - low) * random.between(0.1, 0.9);
    if (k == 2) along = low;
    if (k == 4) along = high;
    all.push_back(p + (along - p.dot(unit)) * unit);
  }
  return all;
}

void askBoth(const Vector3& axis, const Points& a, const Points& b, const Vector3& expected,
             const char* what) {
  for (const Real sign : {1.0, -1.0}) {
    const Vector3 handed = sign * axis + Vector3::Zero();  // so that no zero is a minus zero
    GRADE(orientNormal(handed, a, b), expected, within(0, kExact), given("axis", handed),
          given("a", a, "m"), given("b", b, "m"), about(what));
  }
}

}  // namespace

TEST_CASE("sides") {
  askBoth({1, 0, 0}, cube, boxBetween({0.75, -1, -1}, {2.75, 1, 1}), {1, 0, 0},
          "B is on the right");
  askBoth({0, 0, 1}, cube, boxBetween({-1, -1, -2.5}, {1, 1, -0.5}), {0, 0, -1}, "B hangs below A");
  askBoth({0, 3, 0}, cube, boxBetween({-1, 2, -1}, {1, 3, 1}), {0, 3, 0},
          "B is apart from A; the axis is not of length one, and need not be");
}

TEST_CASE("centres") {
  // A nail of 10 m with its head at x = 1 m, and a body that is 4 m behind the head's front.
  const Points nail = {{-9, 0, 0}, {1, -1, -1}, {1, 1, -1}, {1, 0, 1}};
  const Points wedge = {{-3, -1, 0}, {-3, 1, 0}, {-3, 0, 1}, {-1, 0, 0}};
  askBoth({1, 0, 0}, nail, wedge, {1, 0, 0},
          "a nail with its head on the right: B is 4 m from coming out there, and 8 m at the tip");
  askBoth({1, 0, 0}, wedge, nail, {-1, 0, 0}, "the same two, with A and B exchanged");
  // Corners crowd at one end: their mean lies on the wrong side.
  askBoth({0, 0, 1}, {{1, 0, 2}, {0, 0, -4}, {0, 1, 2}, {-1, 0, 2}, {0, -1, 2}, {0.5, 0.5, 2}},
          {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, {0.5, 0.5, 0}, {0, -1, 0}}, {0, 0, 1},
          "bodies whose corners crowd at one end");
  askBoth({0, 2, 0}, {{0, -3, 0}, {1, -3, 0}, {0, -3, 1}, {0, 5, 0}, {0.2, -3, 0.2}},
          {{0.5, 0, 0}, {0, 0, 0.5}, {0, -1, 0}, {0, 0, 0}, {0.2, 0, 0.2}}, {0, -2, 0},
          "bodies whose corners crowd at one end, along y");
}

TEST_CASE("inside") {
  askBoth({1, 0, 0}, cube, boxBetween({0.25, -0.25, -0.25}, {0.75, 0.25, 0.25}), {1, 0, 0},
          "B wholly inside A, near its right side");
  askBoth({1, 0, 0}, boxBetween({0.25, -0.25, -0.25}, {0.75, 0.25, 0.25}), cube, {-1, 0, 0},
          "A wholly inside B, near its right side");
  GRADE(orientNormal({0, -2, 0}, cube, cube), Vector3(0, -2, 0), within(0, kExact),
        given("axis", Vector3(0, -2, 0)), given("a", "the cube [-1,1]^3"),
        given("b", "the same cube"), about("both ways are equally long: the axis keeps its own"));
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Vector3 unit = random.direction();
    const Real highA = random.between(-3, 3), lowA = highA - random.between(1, 9);
    const Real depth = random.between(0.05, 0.4);
    const Points a = between(random, unit, lowA, highA);
    const Points b = between(random, unit, highA - depth, highA + random.between(0.5, 9));
    const Vector3 axis = random.between(0.3, 3) * unit;
    askBoth(axis, a, b, axis, "B begins just before A ends");
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(orientNormal({1, 0, 0}, Points{}, cube), about("a body without corners"));
}

PROBES() {
  Random random(402);
  for (int n = 0; n < 28; ++n) {
    const Vector3 unit = random.direction();
    const auto body = [&] {
      const Real high = random.between(1, 6), low = random.between(-6, 0);
      return between(random, unit, low, high);
    };
    const Points a = body();
    const Points b = body();
    PROBE(orientNormal(unit, a, b));
  }
  PROBE(orientNormal({0, -2, 0}, cube, cube));
}
