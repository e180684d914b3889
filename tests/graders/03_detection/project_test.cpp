// Grader of 03.project: coordinates along the axes, and points that are placed at known coordinates
// along any direction.

#include "carom/detection/project.hpp"

#include <algorithm>
#include <cmath>

#include "graders/solids.hpp"
#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

// Any vector square to a direction.
Vector3 acrossOf(Random& random, const Vector3& direction) {
  const Vector3 v = random.vector(4);
  return v - v.dot(direction) * direction;
}

// Points whose coordinates along a direction are known, and are anything across it.
Points pointsAt(Random& random, const Vector3& direction, const std::vector<Real>& coordinates) {
  Points points;
  for (const Real c : coordinates) points.push_back(c * direction + acrossOf(random, direction));
  return points;
}

}  // namespace

TEST_CASE("axes") {
  const Points points = {{2, -1, 5}, {4, 3, 6}, {3, 7, 8}};
  GRADE(project(points, {1, 0, 0}), Interval({2, 4}), within(0, "along x it is the coordinate"),
        given("points", points, "m"), given("axis", Vector3(1, 0, 0)), unit("m"));
  GRADE(project(points, {0, -1, 0}), Interval({-7, 1}), within(0, "minus the coordinate"),
        given("points", points, "m"), given("axis", Vector3(0, -1, 0)), unit("m"));
  const Points single = {{1, 2, 3}};
  GRADE(project(single, {0, 0, 1}), Interval({3, 3}), within(0, "a point's shadow is a point"),
        given("points", single, "m"), given("axis", Vector3(0, 0, 1)), unit("m"));
}

TEST_CASE("metres") {
  const Points points = {{0, 0, 0}, {3, 4, 0}, {-3, -4, 7}};
  for (const Real size : {1.0, 2.0, 0.125}) {
    const Vector3 axis = size * Vector3(3, 4, 0);
    GRADE(project(points, axis), Interval({-5, 5}), within(1e-14, kRounding),
          given("points", points, "m"), given("axis", axis), unit("m"),
          about("how long the axis is must not matter"));
  }
  const Points cube = {{1, 1, 1}, {1, 1, -1}, {-1, 1, 1}, {-1, -1, -1}};
  GRADE(project(cube, {1, 1, 1}), Interval({-std::sqrt(3.0), std::sqrt(3.0)}),
        within(1e-14, kRounding), given("points", cube, "m"), given("axis", Vector3(1, 1, 1)),
        unit("m"), about("the diagonal of a cube"));
}

TEST_CASE("placed") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Vector3 direction = random.direction();
    const Real away = random.between(-6, 6);
    std::vector<Real> coordinates;
    for (int k = 0; k < 6; ++k) coordinates.push_back(away + random.between(-2, 2));
    const Points points = pointsAt(random, direction, coordinates);
    const Vector3 axis = random.between(0.2, 5) * direction;
    const auto [low, high] = std::minmax_element(coordinates.begin(), coordinates.end());
    GRADE(project(points, axis), Interval({*low, *high}), within(1e-13, kRounding),
          given("points", points, "m"), given("axis", axis), unit("m"));
  }
}

TEST_CASE("refuses") {
  const Points points = {{1, 2, 3}};
  GRADE_REFUSES(project(points, {0, 0, 0}), given("axis", Vector3(0, 0, 0)));
  GRADE_REFUSES(project(Points{}, {1, 0, 0}), about("no points at all"));
}

PROBES() {
  Random random(304);
  for (int n = 0; n < 16; ++n) {
    const Vector3 away = random.vector(4);
    Points points;
    for (int k = 0; k < 5; ++k) points.push_back(away + random.vector());
    PROBE(project(points, anyVector(random, 0.3, 3)));
  }
}
