// Grader of 03.sat_polygons: a square and its neighbours, whose numbers are exact, and any
// polygons, judged by all differences of their corners.

#include "carom/detection/sat_polygons.hpp"

#include <algorithm>
#include <cmath>

#include "graders/03_detection/differences.hpp"
#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "these numbers are exact";
constexpr const char* kYesNo = "one of three words";
constexpr const char* kRounding = "a few roundings of coordinates of this size";

using Corners = std::vector<Vector2>;

Corners rectangle(Real x0, Real y0, Real x1, Real y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

const Corners square = rectangle(0, 0, 2, 2);

// A convex polygon: points on a circle in order, no two close together.
Corners polygon(Random& random, int corners, const Vector2& center, Real radius) {
  Corners all;
  const Real start = random.between(0, 6.28);
  for (int k = 0; k < corners; ++k) {
    const Real angle = start + (k + random.between(-0.3, 0.3)) * 6.283185307179586 / corners;
    all.push_back(center + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return all;
}

// What is drawn is drawn in an order that does not depend on the compiler.
Corners anyPolygon(Random& random, const Vector2& center) {
  const Real radius = random.between(0.5, 2);
  return polygon(random, random.integer(3, 5), center, radius);
}
Vector2 anyPlace(Random& random) {
  const Real y = random.between(-2, 2);
  return {random.between(-2, 2), y};
}

struct Neighbour {
  const char* what;
  Corners b;
  const char* verdict;
  Real separation;
};

const Neighbour neighbours[] = {
    {"they share an edge", rectangle(2, 0, 4, 2), "touching", 0},
    {"they share part of an edge", rectangle(2, 1, 3, 5), "touching", 0},
    {"a corner of B on an edge of A", {{2, 1}, {4, 0}, {4, 2}}, "touching", 0},
    {"corner on corner", rectangle(2, 2, 3, 3), "touching", 0},
    {"a gap of 1 m", rectangle(3, 0, 4, 2), "separated", 1},
    {"an overlap of 0.5 m", rectangle(1.5, -1, 4, 3), "overlapping", -0.5},
    {"B is one unit in the last place too far left", rectangle(0x1.fffffffffffffp0, 0, 3, 2),
     "overlapping", -0x1p-52},
    {"B is one unit in the last place too far right", rectangle(0x1.0000000000001p1, 0, 3, 2),
     "separated", 0x1p-51},
};

// A slanted gap: only an edge of the second polygon shows it.
const Corners lowTriangle = {{0, 0}, {2, 0}, {0, 2}};
const Corners highSquare = rectangle(1.2, 1.2, 3, 3);

}  // namespace

TEST_CASE("square") {
  for (const Neighbour& n : neighbours) {
    GRADE(inWords(satPolygons(square, n.b).verdict), n.verdict, within(0, kYesNo),
          given("a", square, "m"), given("b", n.b, "m"), about(n.what));
    GRADE(satPolygons(square, n.b).separation, n.separation, within(0, kExact),
          given("a", square, "m"), given("b", n.b, "m"), unit("m"), about(n.what));
  }
}

TEST_CASE("both") {
  const Real gap = (1.2 + 1.2 - 2) / std::sqrt(2.0);
  GRADE(satPolygons(lowTriangle, highSquare).separation, gap, within(1e-15, kRounding),
        given("a", lowTriangle, "m"), given("b", highSquare, "m"), unit("m"),
        about("only the slanted edge, which is an edge of a, shows the gap"));
  GRADE(satPolygons(highSquare, lowTriangle).separation, gap, within(1e-15, kRounding),
        given("a", highSquare, "m"), given("b", lowTriangle, "m"), unit("m"),
        about("only the slanted edge, which is an edge of b, shows the gap"));
  GRADE(satPolygons(highSquare, lowTriangle).axis, Vector3(-std::sqrt(0.5), -std::sqrt(0.5), 0),
        within(1e-15, kRounding), given("a", highSquare, "m"), given("b", lowTriangle, "m"),
        about("a unit vector from A to B"));
  GRADE(inWords(satPolygons(highSquare, lowTriangle).kind), "a face of B", within(0, kYesNo),
        given("a", highSquare, "m"), given("b", lowTriangle, "m"), about("whose edge it is"));
  GRADE(satPolygons(highSquare, lowTriangle).featureB, 1, within(0, "the number of an edge"),
        given("a", highSquare, "m"), given("b", lowTriangle, "m"),
        about("the edge from corner 1 to corner 2 has the number 1"));
}

TEST_CASE("inside") {
  const Corners small = rectangle(0.5, 0.75, 1, 1.25);
  GRADE(satPolygons(square, small).separation, -1, within(0, kExact), given("a", square, "m"),
        given("b", small, "m"), unit("m"),
        about("b lies wholly inside a; 0.5 m to the left it would still be inside"));
  GRADE(satPolygons(square, small).axis, Vector3(-1, 0, 0), within(0, kExact),
        given("a", square, "m"), given("b", small, "m"), about("the shortest way out"));
  GRADE(satPolygons(square, square).separation, -2, within(0, kExact), given("a", square, "m"),
        given("b", square, "m"), unit("m"), about("the same square twice"));
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Corners a = anyPolygon(random, {0, 0});
    const Vector2 place = anyPlace(random);
    const Corners b = anyPolygon(random, place);
    const BestGap best = bestGap(a, b);
    GRADE(satPolygons(a, b).separation, best.gap, within(1e-14, kRounding), given("a", a, "m"),
          given("b", b, "m"), unit("m"));
    if (!best.isUnique()) continue;
    GRADE(satPolygons(a, b).axis, best.axis, within(1e-14, kRounding), given("a", a, "m"),
          given("b", b, "m"), about("a unit vector from A to B"));
  }
}

TEST_CASE("refuses") {
  const Corners segment = {{0, 0}, {1, 0}};
  GRADE_REFUSES(satPolygons(segment, square), given("a", segment, "m"));
}

PROBES() {
  Random random(306);
  for (int n = 0; n < 20; ++n) {
    const Corners a = polygon(random, 3 + n % 3, {0, 0}, random.between(0.5, 2));
    const Vector2 place = anyPlace(random);
    PROBE(satPolygons(a, polygon(random, 3, place, random.between(0.3, 1))));
  }
  PROBE(satPolygons(square, rectangle(2, 0, 4, 2)));
  PROBE(satPolygons(square, rectangle(2, 1, 3, 5)));
}
