// Grader of 03.aabb_of_points: boxes of clouds that are known because they were filled on purpose.

#include "carom/detection/aabb_of_points.hpp"

#include <algorithm>
#include <limits>

#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kCopied = "the sides of the box are coordinates of points, copied";

using Points = std::vector<Vector3>;

Aabb<3> boxOf(const Vector3& low, const Vector3& high) {
  return {low, high};
}

// A cloud that fills a box: one point on each of its six sides, the others inside, in any order.
Points cloudIn(Random& random, const Vector3& low, const Vector3& high) {
  Points points;
  const auto inside = [&] {
    Vector3 p;
    for (int i = 0; i < 3; ++i) {
      p(i) = low(i) + (high(i) - low(i)) * random.between(0.1, 0.9);
    }
    return p;
  };
  for (int side = 0; side < 6; ++side) {
    Vector3 p = inside();
    p(side / 2) = side % 2 ? high(side / 2) : low(side / 2);
    points.push_back(p);
  }
  points.push_back(inside());
  for (std::size_t i = points.size() - 1; i > 0; --i) {
    std::swap(points[i], points[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  }
  return points;
}

}  // namespace

TEST_CASE("away") {
  const Points right = {{2, 3, 4}, {5, 3.5, 7}, {3, 6, 4.5}};
  GRADE(aabbOfPoints(right), boxOf({2, 3, 4}, {5, 6, 7}), within(0, kCopied),
        given("points", right, "m"), unit("m"), about("all on the positive side of the origin"));
  const Points left = {{-2, -3, -4}, {-5, -3.5, -7}, {-3, -6, -4.5}};
  GRADE(aabbOfPoints(left), boxOf({-5, -6, -7}, {-2, -3, -4}), within(0, kCopied),
        given("points", left, "m"), unit("m"), about("all on the negative side of the origin"));
  const Points one = {{1.5, -2, 8}};
  GRADE(aabbOfPoints(one), boxOf({1.5, -2, 8}, {1.5, -2, 8}), within(0, kCopied),
        given("points", one, "m"), unit("m"), about("a single point"));
}

TEST_CASE("order") {
  Points points = {{4, 1, 0}, {3, 2, -1}, {2, 3, -2}, {1, 4, -3}};
  const Aabb<3> expected = boxOf({1, 1, -3}, {4, 4, 0});
  GRADE(aabbOfPoints(points), expected, within(0, kCopied), given("points", points, "m"), unit("m"),
        about("coordinates that fall or rise all the way"));
  std::reverse(points.begin(), points.end());
  GRADE(aabbOfPoints(points), expected, within(0, kCopied), given("points", points, "m"), unit("m"),
        about("the same points in the other order"));
}

TEST_CASE("clouds") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Vector3 low = random.vector(10);
    Vector3 high = low;
    for (Real& x : high) x += random.between(0.5, 5);
    const Points points = cloudIn(random, low, high);
    GRADE(aabbOfPoints(points), boxOf(low, high), within(0, kCopied), given("points", points, "m"),
          unit("m"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(aabbOfPoints(Points{}), about("no points at all"));
  const Points infinite = {{0, 0, 0}, {std::numeric_limits<Real>::infinity(), 0, 0}};
  GRADE_REFUSES(aabbOfPoints(infinite), given("points", infinite, "m"));
}

PROBES() {
  Random random(302);
  for (int n = 0; n < 16; ++n) {
    Points points;
    const Vector3 away = random.vector(3);
    for (int i = 0; i < 4 + n % 3; ++i) points.push_back(away + random.vector());
    PROBE(aabbOfPoints(points));
  }
}
