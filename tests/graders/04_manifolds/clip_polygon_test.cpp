// Grader of 04.clip_polygon: a square whose cuts can be drawn, corners that lie on the plane, and
// any polygons, of which corners, area and sides of the plane are compared. It does not matter with
// which corner the answer begins.

#include "carom/manifold/clip_polygon.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "graders/solids.hpp"
#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of coordinates of this size";

// The same loop, begun at the corner that lies farthest in a direction that no plane here shares.
Points fromOneCorner(Points loop) {
  const Vector3 direction(0.8, -0.35, 0.49);
  const auto first = std::max_element(
      loop.begin(), loop.end(),
      [&](const Vector3& p, const Vector3& q) { return direction.dot(p) < direction.dot(q); });
  std::rotate(loop.begin(), first, loop.end());
  return loop;
}

const Points square = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};

// A convex polygon in any plane: points on a circle, in order.
Points polygon(Random& random, int corners) {
  const Vector3 n = random.direction();
  const Vector3 u =
      cross(n, std::abs(n.x()) < 0.7 ? Vector3::UnitX() : Vector3::UnitY()).normalized();
  const Vector3 v = cross(n, u);
  const Vector3 center = random.vector(2);
  Points all;
  for (int k = 0; k < corners; ++k) {
    const Real angle = (k + random.between(-0.3, 0.3)) * 6.283185307179586 / corners;
    all.push_back(center + 2 * std::cos(angle) * u + 2 * std::sin(angle) * v);
  }
  return all;
}

Vector3 areaVector(const Points& p) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < p.size(); ++i) sum += cross(p[i] - p[0], p[i + 1] - p[0]) / 2;
  return sum;
}

// How far a loop reaches beyond the plane.
Real highest(const Points& p, const Vector3& normal, Real offset) {
  Real height = -1e300;
  for (const Vector3& corner : p) height = std::max(height, normal.dot(corner) - offset);
  return height;
}

struct Cut {
  Points polygon;
  Vector3 normal;
  Real offset = 0;
};

Cut anyCut(Random& random) {
  Cut cut{polygon(random, random.integer(3, 6)), anyVector(random, 0.3, 3), 0};
  Vector3 middle = Vector3::Zero();
  for (const Vector3& p : cut.polygon) middle += p / static_cast<Real>(cut.polygon.size());
  cut.offset = cut.normal.dot(middle + 0.1 * random.vector());
  return cut;
}

void askSquare(const Vector3& normal, Real offset, const Points& expected, const char* what) {
  GRADE(fromOneCorner(clipPolygon(square, normal, offset)), fromOneCorner(expected),
        within(1e-15, kRounding), given("polygon", square, "m"), given("normal", normal),
        given("offset", offset), unit("m"), about(what));
}

}  // namespace

TEST_CASE("square") {
  askSquare({1, 0, 0}, 3, {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}}, "cut off at x = 3 m");
  askSquare({0, -1, 0}, -1, {{0, 1, 0}, {4, 1, 0}, {4, 4, 0}, {0, 4, 0}},
            "cut off below y = 1 m: the edge that closes the square is cut too");
  askSquare({1, 1, 0}, 7, {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 4, 0}, {0, 4, 0}},
            "one corner cut off: five are left");
  askSquare({-2, 0, 0}, -6, {{3, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}},
            "a normal that is not of length one");
}

TEST_CASE("whole") {
  askSquare({1, 0, 0}, 9, square, "all of it lies behind the plane");
  askSquare({1, 0, 0}, 4, square, "two corners on the plane, the others behind");
  GRADE(clipPolygon(square, {1, 0, 0}, -2).size(), std::size_t{0}, within(0, "a count"),
        given("polygon", square, "m"), given("normal", Vector3(1, 0, 0)), given("offset", -2.0),
        about("all of it lies in front of the plane"));
  GRADE(clipPolygon(Points{}, {1, 0, 0}, 0).size(), std::size_t{0}, within(0, "a count"),
        given("polygon", "empty"), about("nothing is left of nothing"));
}

TEST_CASE("corners") {
  askSquare({1, -1, 0}, 0, {{0, 0, 0}, {4, 4, 0}, {0, 4, 0}},
            "cut along the diagonal: the two corners on the plane occur once each");
  askSquare({1, 1, 0}, 8, square, "the plane touches one corner from outside");
  askSquare({-1, -2, 0}, -4, {{4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 2, 0}},
            "the plane passes through one corner and cuts one edge");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Cut cut = anyCut(random);
    const Points other = clipPolygon(cut.polygon, -cut.normal, -cut.offset);
    GRADE(Vector3(areaVector(clipPolygon(cut.polygon, cut.normal, cut.offset)) + areaVector(other)),
          areaVector(cut.polygon), within(1e-13, kRounding), given("polygon", cut.polygon, "m"),
          given("normal", cut.normal), given("offset", cut.offset), unit("m^2"),
          about("the areas behind and in front of the plane, as vectors, add up to the whole"));
    GRADE(highest(clipPolygon(cut.polygon, cut.normal, cut.offset), cut.normal, cut.offset), 0,
          within(1e-13, kRounding), given("polygon", cut.polygon, "m"), given("normal", cut.normal),
          given("offset", cut.offset), about("the highest corner of what is left, over the plane"));
  }
}

PROBES() {
  Random random(403);
  for (int n = 0; n < 16; ++n) {
    const Cut cut = anyCut(random);
    const Points left = clipPolygon(cut.polygon, cut.normal, cut.offset);
    PROBE(left);
  }
  PROBE(clipPolygon(square, {1, -1, 0}, 0));
  PROBE(clipPolygon(square, {1, 0, 0}, 4));
}
