// Grader of 03.gjk_distance: boxes beside each other, whose distances are known; boxes that touch
// under any turn, which must come to an end; and any bodies, whose answer proves itself.

#include "carom/detection/gjk_distance.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "graders/solids.hpp"
#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of coordinates of this size";

Points box(const Vector3& center, const Vector3& half) {
  Points all;
  for (int n = 0; n < 8; ++n) all.push_back(center + half.cwiseProduct(cubeCorner(n)));
  return all;
}

Points cubeAt(const Vector3& center, Real half = 1) {
  return box(center, Vector3::Constant(half));
}

Points cloud(Random& random, const Vector3& center) {
  Points all;
  for (int k = 0; k < 7; ++k) all.push_back(center + random.vector());
  return all;
}

// How far the bodies reach beyond the planes through the two points, square to their connection. If
// they do not, nothing nearer exists, so the distance is right.
Real reachBeyond(const Points& a, const Points& b, const PointDistance& d) {
  if (!(d.distance > 0)) return 1;
  const Vector3 normal = (d.pointB - d.pointA) / d.distance;
  Real reach = std::abs((d.pointB - d.pointA).norm() - d.distance);
  for (const Vector3& p : a) reach = std::max(reach, normal.dot(p - d.pointA));
  for (const Vector3& q : b) reach = std::max(reach, normal.dot(d.pointB - q));
  return reach;
}

// How many of some pairs of cubes that touch, by a face, an edge or a corner, under any turn, took
// more support points than both have corners together, threefold.
int longSearches(std::uint64_t start) {
  Random random(start);
  int count = 0;
  for (int n = 0; n < 80; ++n) {
    const Vector3 beside(2, n % 3 == 0 ? 0.5 : 2, n % 3 == 2 ? 2 : 0.25);
    const Matrix3 R = anyTurn(random, 0, 3);
    const Vector3 place = random.vector(3);
    const PointDistance d =
        gjkDistance(moved(cubeAt({0, 0, 0}), R, place), moved(cubeAt(beside), R, place));
    count += d.iterations > 48;
  }
  return count;
}

}  // namespace

TEST_CASE("boxes") {
  struct Case {
    Vector3 center;
    Real distance;
    const char* what;
  };
  const Case cases[] = {{{3.5, 0.25, -0.5}, 1.5, "face against face"},
                        {{5, 6, 0.5}, 5, "edge against edge"},
                        {{-3, 4, -4}, 3, "corner against corner"},
                        {{0.5, 0.25, 0.75}, 0, "one in the other"}};
  for (const Case& c : cases) {
    GRADE(gjkDistance(cubeAt({0, 0, 0}), cubeAt(c.center)).distance, c.distance,
          within(2e-15, kRounding), given("a", "a cube of edge 2 m at the origin"),
          given("b", "the same cube"), given("centre of b", c.center, "m"), unit("m"),
          about(c.what));
  }
}

TEST_CASE("points") {
  GRADE(gjkDistance(cubeAt({0, 0, 0}), cubeAt({-3, 4, -4})).pointA, Vector3(-1, 1, -1),
        within(2e-15, kRounding), given("a", "a cube of edge 2 m at the origin"),
        given("centre of b, the same cube", Vector3(-3, 4, -4), "m"), unit("m"),
        about("the nearest corner of a"));
  GRADE(gjkDistance(cubeAt({0, 0, 0}), cubeAt({-3, 4, -4})).pointB, Vector3(-2, 3, -3),
        within(2e-15, kRounding), given("a", "a cube of edge 2 m at the origin"),
        given("centre of b, the same cube", Vector3(-3, 4, -4), "m"), unit("m"),
        about("the nearest corner of b"));
  const Points point = {{1, 1, 2}};
  const Points triangle = {{0, 0, 0}, {3, 0, 0}, {0, 3, 1}};
  GRADE(gjkDistance(point, triangle).pointB, Vector3(1, 1.5, 0.5), within(2e-15, kRounding),
        given("a", point, "m"), given("b", triangle, "m"), unit("m"),
        about("a point inside the triangle, of which no corner is nearest"));
  const Points segment = {{0, 0, 0}, {1, 0, 0}};
  const Points skew = {{0.5, 1, -1}, {0.5, 2, 3}};
  GRADE(gjkDistance(segment, skew).pointA, Vector3(0.5, 0, 0), within(2e-15, kRounding),
        given("a", segment, "m"), given("b", skew, "m"), unit("m"));
  GRADE(gjkDistance(segment, skew).pointB, Vector3(0.5, 20.0 / 17, -5.0 / 17),
        within(2e-15, kRounding), given("a", segment, "m"), given("b", skew, "m"), unit("m"));
}

TEST_CASE("touching") {
  GRADE(longSearches(seed()), 0, within(0, "a count"),
        about("pairs, of 80 that just touch, that took more than 48 support points"));
  const Matrix3 R = turn(Vector3(2, -1, 2) / 3, 0.7);
  for (const Real gap : {0.0, 1e-9, 1e-6}) {
    const Points a = moved(cubeAt({0, 0, 0}), R, {1, 2, 3});
    const Points b = moved(cubeAt({2 + gap, 0.5, 0.25}), R, {1, 2, 3});
    GRADE(gjkDistance(a, b).distance, gap, within(8e-15, kRounding), given("a", a, "m"),
          given("b", b, "m"), unit("m"), about("two cubes side by side"));
  }
}

TEST_CASE("sizes") {
  for (const Real size : {1e-6, 1e-3, 1e6}) {
    const Vector3 center = size * Vector3(-3, 4, -4);
    GRADE(gjkDistance(cubeAt({0, 0, 0}, size), cubeAt(center, size)).distance, 3 * size,
          withinRelative(1e-14, kRounding), given("a", "a cube at the origin"),
          given("half its edge", size, "m"), given("b", "the same cube"),
          given("centre of b", center, "m"), unit("m"));
  }
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Points a = cloud(random, {0, 0, 0});
    const Vector3 away = random.between(3.6, 5) * random.direction();
    const Points b = cloud(random, away);
    GRADE(
        reachBeyond(a, b, gjkDistance(a, b)), 0, within(1e-13, kRounding), given("a", a, "m"),
        given("b", b, "m"), unit("m"),
        about("how far the bodies reach between the two nearest points that you gave: nothing, if "
              "these are the nearest"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(gjkDistance(Points{}, cubeAt({0, 0, 0})), about("a body without corners"));
}

PROBES() {
  Random random(310);
  for (int n = 0; n < 16; ++n) {
    const Points a = cloud(random, {0, 0, 0});
    const Points b = cloud(random, anyVector(random, 2.5, 4));
    const PointDistance d = gjkDistance(a, b);
    PROBE(Vector3(d.distance, d.distance > 0.2 ? d.pointA.x() : 0,
                  d.distance > 0.2 ? d.pointB.y() : 0));
  }
  PROBE(longSearches(310) > 0);
  PROBE(1e6 * gjkDistance(cubeAt({0, 0, 0}, 1e-6), cubeAt({-3e-6, 4e-6, -4e-6}, 1e-6)).distance);
}
