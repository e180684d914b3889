// Grader of 04.reduce_contacts: rectangles with bulges, of which the best four are known, and
// regular polygons pulled askew, of which the largest area is known. Where several choices are as
// good, the area is asked and not the numbers.

#include "carom/manifold/reduce_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";
constexpr const char* kNumbers = "numbers of corners";

using Points = std::vector<Vector3>;
using Reals = std::vector<Real>;
using Numbers = std::vector<int>;

// A rectangle of 4 x 3 m with a flat bulge on two sides: corners 2 and 5 are the bulges.
const Points bulged = {{0, 0, 0}, {4, 0, 0}, {4.2, 1.5, 0}, {4, 3, 0}, {0, 3, 0}, {-0.2, 1.5, 0}};

// A rectangle of 4 x 3 m with one bulge, corner 3, near its corner 4.
const Points oneBulge = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {1, 3.1, 0}, {0, 3, 0}};

// A regular polygon, pulled askew in any plane: the largest quadrilateral in it is the image of the
// square, with an area of 2 |a x b|.
struct Askew {
  Points corners;
  Vector3 a, b;
  Real largest() const {
    return 2 * cross(a, b).norm();
  }
};

Askew askew(Random& random, int n) {
  Askew polygon;
  do {
    polygon.a = 2 * random.vector();
    polygon.b = 2 * random.vector();
  } while (cross(polygon.a, polygon.b).norm() < 0.5);
  const Vector3 center = random.vector(3);
  for (int k = 0; k < n; ++k) {
    const Real angle = 6.283185307179586 * k / n;
    polygon.corners.push_back(center + std::cos(angle) * polygon.a + std::sin(angle) * polygon.b);
  }
  return polygon;
}

// The area of the chosen corners; -1 if they are not four different ones in ascending order.
Real areaKept(const Points& corners, const Numbers& kept) {
  if (kept.size() != 4) return -1;
  for (std::size_t k = 0; k < 4; ++k) {
    if (kept[k] < 0 || kept[k] >= static_cast<int>(corners.size())) return -1;
    if (k > 0 && kept[k] <= kept[k - 1]) return -1;
  }
  const auto at = [&](int k) {
    return corners[static_cast<std::size_t>(kept[static_cast<std::size_t>(k)])];
  };
  return (cross(at(1) - at(0), at(2) - at(0)) + cross(at(2) - at(0), at(3) - at(0))).norm() / 2;
}

bool isAmong(const Numbers& kept, int number) {
  return std::find(kept.begin(), kept.end(), number) != kept.end();
}

// Separations that grow evenly along a slope.
Reals sloped(const Points& corners, const Vector3& slope) {
  Reals all;
  for (const Vector3& p : corners) all.push_back(-1 + slope.dot(p));
  return all;
}

}  // namespace

TEST_CASE("few") {
  const Points three = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  GRADE(reduceContacts(three, Reals{-0.1, 0, -0.2}), Numbers({0, 1, 2}), within(0, kNumbers),
        given("corners", three, "m"), about("three corners are all kept"));
  const Points four = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  GRADE(reduceContacts(four, Reals{-0.1, 0, -0.2, 0}), Numbers({0, 1, 2, 3}), within(0, kNumbers),
        given("corners", four, "m"), about("four corners are all kept"));
}

TEST_CASE("area") {
  const Reals even(6, -0.1);
  GRADE(reduceContacts(bulged, even), Numbers({0, 1, 3, 4}), within(0, kNumbers),
        given("corners", bulged, "m"), given("separations", even, "m"),
        about("a rectangle with two flat bulges: its own corners span most"));
  const Reals slope = sloped(bulged, {0.1, 0.05, 0});
  GRADE(reduceContacts(bulged, slope), Numbers({0, 1, 3, 4}), within(0, kNumbers),
        given("corners", bulged, "m"), given("separations", slope, "m"),
        about("the same, deepest at corner 0"));
  const Points crowded = {{0, 0, 0},       {4, 0, 0},   {4, 2.9, 0},
                          {3.95, 2.97, 0}, {3.9, 3, 0}, {0, 3, 0}};
  GRADE(reduceContacts(crowded, even), Numbers({0, 1, 3, 5}), within(0, kNumbers),
        given("corners", crowded, "m"), given("separations", even, "m"),
        about("a rectangle with one corner rounded: three corners stand close together"));
  Random random(seed());
  for (int n = 0; n < 10; ++n) {
    const Askew polygon = askew(random, 8 + 4 * (n % 3));
    const Reals flat(polygon.corners.size(), -0.01);
    GRADE(areaKept(polygon.corners, reduceContacts(polygon.corners, flat)), polygon.largest(),
          withinRelative(1e-12, kRounding), given("corners", polygon.corners, "m"), unit("m^2"),
          about("area of the four that you kept, all equally deep; -1 if they are not four in "
                "ascending order"));
  }
}

TEST_CASE("deepest") {
  const Reals deepBulge = {-0.1, -0.1, -0.1, -0.3, -0.1};
  GRADE(reduceContacts(oneBulge, deepBulge), Numbers({0, 1, 2, 3}), within(0, kNumbers),
        given("corners", oneBulge, "m"), given("separations", deepBulge, "m"),
        about("the deepest corner takes the place of its neighbour 4, which costs least area"));
  const Reals deepSide = {-0.1, -0.1, -0.5, -0.1, -0.1, -0.1};
  GRADE(isAmong(reduceContacts(bulged, deepSide), 2), true, within(0, "yes or no"),
        given("corners", bulged, "m"), given("separations", deepSide, "m"),
        about("is the deepest corner, number 2, among them?"));
  GRADE(areaKept(bulged, reduceContacts(bulged, deepSide)), 9.3, within(1e-14, kRounding),
        given("corners", bulged, "m"), given("separations", deepSide, "m"), unit("m^2"),
        about("area of the four that you kept: one of corner 2's neighbours has gone"));
}

TEST_CASE("flat") {
  const Reals rounded = {-0.1, -0.1, -0.1, -0.1 - 1e-13, -0.1};
  GRADE(reduceContacts(oneBulge, rounded), Numbers({0, 1, 2, 4}), within(0, kNumbers),
        given("corners", oneBulge, "m"), given("separations", rounded, "m"),
        about("corner 3 is deeper by a rounding only: that must not decide"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(reduceContacts(oneBulge, Reals{-0.1, -0.1}),
                about("five corners and two separations"));
}

PROBES() {
  Random random(407);
  for (int n = 0; n < 16; ++n) {
    // An irregular convex polygon with a single best choice, and any depths.
    Points corners;
    const int count = 6 + n % 4;
    for (int k = 0; k < count; ++k) {
      const Real angle = 6.283185307179586 * (k + random.between(-0.4, 0.4)) / count;
      corners.push_back({3 * std::cos(angle), 2 * std::sin(angle), 0});
    }
    Reals depths;
    for (int k = 0; k < count; ++k) depths.push_back(-random.between(0.01, 0.2));
    PROBE(reduceContacts(corners, depths));
  }
  PROBE(reduceContacts(Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Reals{0, 0, 0}));
  PROBE(reduceContacts(oneBulge, Reals{-0.1, -0.1, -0.1, -0.1 - 1e-13, -0.1}));
}
