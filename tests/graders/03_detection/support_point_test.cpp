// Grader of 03.support_point: directions in which the farthest corner can be seen, and clouds in
// which one point has been put beyond all others.

#include "carom/detection/support_point.hpp"

#include <cmath>

#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kIndex = "the number of a point";

using Points = std::vector<Vector3>;

const Points cube = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                     {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};

// Points behind a plane square to the direction, and one in front of it, with the number `index`.
Points withFarthest(Random& random, const Vector3& direction, std::size_t index, Real offset) {
  Points points;
  for (std::size_t i = 0; i < 9; ++i) {
    Vector3 p = random.vector(3);
    p += (offset - 0.5 - random.between(0, 2) - p.dot(direction)) * direction;
    if (i == index) p += (offset - p.dot(direction)) * direction;
    points.push_back(p);
  }
  return points;
}

}  // namespace

TEST_CASE("cube") {
  struct Case {
    Vector3 direction;
    std::size_t index;
  };
  const Case cases[] = {
      {{1, 2, 3}, 7}, {{1, 2, -3}, 3}, {{-1, 2, 3}, 6}, {{1, -2, 3}, 5}, {{-3, -2, 1}, 4}};
  for (const Case& c : cases) {
    GRADE(supportPoint(cube, c.direction), c.index, within(0, kIndex), given("points", cube, "m"),
          given("direction", c.direction));
  }
}

TEST_CASE("behind") {
  const Points away = {{-9, 1, 0}, {-8, 5, 1}, {-4, -2, 2}, {-3, 0, 0}, {-7, 3, 3}};
  GRADE(supportPoint(away, {1, 0, 0}), std::size_t{3}, within(0, kIndex),
        given("points", away, "m"), given("direction", Vector3(1, 0, 0)),
        about("the whole body lies behind the origin, so all inner products are negative"));
  GRADE(supportPoint(away, {0, 0, -5}), std::size_t{0}, within(0, kIndex),
        given("points", away, "m"), given("direction", Vector3(0, 0, -5)),
        about("two points lie equally far: the first counts"));
  GRADE(supportPoint(cube, {0, 1, 0}), std::size_t{2}, within(0, kIndex),
        given("points", cube, "m"), given("direction", Vector3(0, 1, 0)),
        about("four points lie equally far: the first counts"));
}

TEST_CASE("clouds") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Vector3 direction = random.direction();
    const std::size_t index = static_cast<std::size_t>(2 + n % 7);
    const Points points = withFarthest(random, direction, index, random.between(-6, 6));
    const Vector3 given_direction = random.between(0.1, 10) * direction;
    GRADE(supportPoint(points, given_direction), index, within(0, kIndex),
          given("points", points, "m"), given("direction", given_direction));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(supportPoint(Points{}, {1, 0, 0}), about("no points at all"));
}

PROBES() {
  Random random(305);
  for (int n = 0; n < 24; ++n) {
    const Vector3 away = random.vector(2);
    Points points;
    for (int k = 0; k < 12; ++k) points.push_back(away + random.vector(2));
    PROBE(supportPoint(points, random.direction()));
  }
  PROBE(supportPoint(cube, {0, 1, 0}));
  PROBE(supportPoint(cube, {0, 0, -1}));
}
