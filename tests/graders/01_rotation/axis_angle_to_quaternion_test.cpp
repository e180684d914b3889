// Grader of 01.axis_angle_to_quaternion: turns whose quaternion is plain, the square of a quaternion,
// which holds the whole angle, and one turn with 25 digits.

#include "carom/rotation/axis_angle_to_quaternion.hpp"

#include <cmath>

#include "carom/rotation/hamilton_product.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr Real kHalfTurn = 3.14159265358979323846;  // [rad]
constexpr const char* kRounding = "a handful of roundings of numbers up to 1";

Real squaredLength(const Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

// The product of q with itself: the turn twice.
Quaternion square(const Quaternion& q) {
  return hamiltonProduct(q, q);
}

void asks(const Vector3& axis, Real angle, const Quaternion& expected) {
  GRADE(axisAngleToQuaternion(axis, angle), expected, within(1e-15, kRounding), given("axis", axis),
        given("angle", angle, "rad"), upToSign());
}

}  // namespace

TEST_CASE("half_turn") {
  asks({0, 1, 0}, kHalfTurn, {0, 0, 1, 0});
  asks({1, 0, 0}, -kHalfTurn, {0, -1, 0, 0});
  // A third of a turn about the diagonal of a cube.
  const Real third = 1 / std::sqrt(3.0);
  asks({third, third, third}, 2 * kHalfTurn / 3, {0.5, 0.5, 0.5, 0.5});
  asks({0, 0, 1}, kHalfTurn / 3, {std::sqrt(0.75), 0, 0, 0.5});
}

TEST_CASE("twice") {
  Random random(seed());
  for (int n = 0; n < 30; ++n) {
    const Vector3 axis = random.direction();
    const Real angle = random.between(-7, 7);
    const Vector3 v = std::sin(angle) * axis;
    GRADE(square(axisAngleToQuaternion(axis, angle)),
          (Quaternion{std::cos(angle), v.x(), v.y(), v.z()}), within(2e-15, kRounding),
          given("axis", axis), given("angle", angle, "rad"),
          about("q q is the turn by twice the angle, so it holds the whole angle"));
  }
}

TEST_CASE("length") {
  asks({1, 2, 3}, 2.5,
       {0.3153223623952686654475386, 0.2536268079247632993198956, 0.5072536158495265986397912,
        0.7608804237742898979596869});
  asks({0, 0, 20}, 2 * kHalfTurn / 3, {0.5, 0, 0, std::sqrt(0.75)});
  const Vector3 axis(1, 2, 3);
  GRADE(squaredLength(axisAngleToQuaternion(axis, 1)), 1, within(2e-15, kRounding),
        given("axis", axis), given("angle", 1.0, "rad"),
        about("the square of the length of the quaternion"));
  const Vector3 small(3e-5, 0, 4e-5);
  asks(small, 2 * kHalfTurn / 3, {0.5, 0.6 * std::sqrt(0.75), 0, 0.8 * std::sqrt(0.75)});
}

TEST_CASE("refuses") {
  const Vector3 zero(0, 0, 0);
  GRADE_REFUSES(axisAngleToQuaternion(zero, 1), given("axis", zero), given("angle", 1.0, "rad"));
  GRADE_REFUSES(axisAngleToQuaternion(zero, 0), given("axis", zero), given("angle", 0.0, "rad"));
}

PROBES() {
  Random random(14);
  for (int n = 0; n < 20; ++n) {
    const Vector3 axis = random.vector(2);
    PROBE(axisAngleToQuaternion(axis, random.between(-4, 4)));
  }
  PROBE(axisAngleToQuaternion(Vector3(0, 0, 0), 1));
}
