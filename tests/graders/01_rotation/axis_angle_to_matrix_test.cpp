// Grader of 01.axis_angle_to_matrix: points whose way is known, the invariants of a turn (its axis, its
// trace, its square), and one point with 25 digits.

#include "carom/rotation/axis_angle_to_matrix.hpp"

#include <cmath>

#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kQuarter = 1.57079632679489661923;  // [rad]
constexpr const char* kRounding = "a handful of roundings of numbers up to 1";

const Vector3 ex(1, 0, 0);
const Vector3 ey(0, 1, 0);
const Vector3 ez(0, 0, 1);

Vector3 turned(const Vector3& axis, Real angle, const Vector3& point) {
  return axisAngleToMatrix(axis, angle) * point;
}

Real trace(const Matrix3& R) {
  return R(0, 0) + R(1, 1) + R(2, 2);
}

void asksWhere(const Vector3& axis, Real angle, const Vector3& point, const Vector3& expected,
               const char* question = "where does the turn take this point?") {
  GRADE(turned(axis, angle, point), expected, withinRelative(2e-15, kRounding), given("axis", axis),
        given("angle", angle, "rad"), given("point", point), about(question));
}

}  // namespace

TEST_CASE("quarter") {
  asksWhere(ez, kQuarter, ex, ey);
  asksWhere(ex, kQuarter, ey, ez);
  asksWhere(ey, kQuarter, ez, ex);
  asksWhere(ez, -kQuarter, ex, {0, -1, 0});
  asksWhere(ey, 2 * kQuarter, {1, 2, 3}, {-1, 2, -3});
}

TEST_CASE("axis_stays") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Vector3 axis = random.direction();
    const Real angle = random.between(-7, 7);
    asksWhere(axis, angle, axis, axis, "the axis of a turn does not move");
    GRADE(trace(axisAngleToMatrix(axis, angle)), 1 + 2 * std::cos(angle), within(3e-15, kRounding),
          given("axis", axis), given("angle", angle, "rad"),
          about("the sum of the diagonal, which is 1 + 2 cos(angle) for every axis"));
  }
}

TEST_CASE("point") {
  const Vector3 axis = Vector3(1, 2, 3) / std::sqrt(14.0);
  asksWhere(axis, 2.5, {0.3, -1.2, 2.5},
            {1.829940051431098942900212, 2.094908531362239891730862, -0.2065857047185262421206455});
  // A third of a turn about the diagonal of a cube takes each axis to the next one.
  const Vector3 diagonal = Vector3(1, 1, 1) / std::sqrt(3.0);
  asksWhere(diagonal, 4 * kQuarter / 3, {1, 2, 3}, {3, 1, 2});
  // Half a turn about (0.6, 0, 0.8) mirrors in the axis: 2 a (a . v) - v.
  asksWhere({0.6, 0, 0.8}, 2 * kQuarter, {1, 2, 3}, {2.6, -2, 1.8});
}

TEST_CASE("length") {
  asksWhere({0, 0, 7}, kQuarter, {1, 2, 3}, {-2, 1, 3});
  asksWhere({0.001, 0, 0}, kQuarter, {1, 2, 3}, {1, -3, 2});
  asksWhere({5, 5, 5}, 4 * kQuarter / 3, {1, 2, 3}, {3, 1, 2});
  asksWhere({1, 2, 3}, 2.5, {0.3, -1.2, 2.5},
            {1.829940051431098942900212, 2.094908531362239891730862, -0.2065857047185262421206455});
}

TEST_CASE("refuses") {
  const Vector3 zero(0, 0, 0);
  GRADE_REFUSES(axisAngleToMatrix(zero, 1), given("axis", zero), given("angle", 1.0, "rad"));
  GRADE_REFUSES(axisAngleToMatrix(zero, 0), given("axis", zero), given("angle", 0.0, "rad"));
}

PROBES() {
  Random random(13);
  for (int n = 0; n < 20; ++n) {
    const Vector3 axis = random.vector(2);
    PROBE(axisAngleToMatrix(axis, random.between(-4, 4)));
  }
  PROBE(axisAngleToMatrix(Vector3(0, 0, 0), 1));
}
