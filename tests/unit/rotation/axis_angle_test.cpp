#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_matrix.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;

TEST_CASE("axis and angle give the quaternion and the turned point of case R3") {
  const auto c = caseNamed("R3");
  const Vector3 axis = vector(c["axis"]), v = vector(c["v"]), turned = vector(c["turned"]);
  const Real angle = number(c["angle"]), limit = number(c["accept"]["error / |v|"]) * v.norm();
  const Quaternion q = axisAngleToQuaternion(axis, angle);
  CHECK(distance(q, quaternion(c["q"])) <= 2.3e-16);
  CHECK(distance(rotatePoint(q, v), turned) <= limit);
  CHECK(distance(quaternionToMatrix(q) * v, turned) <= limit);
  CHECK(distance(axisAngleToMatrix(axis, angle) * v, turned) <= limit);
}

TEST_CASE("half a turn about y takes (1, 2, 3) to (-1, 2, -3) (R3)") {
  const auto c = caseNamed("R3")["half turn about y"];
  const Vector3 v = vector(c["v"]), turned = vector(c["turned"]);
  // pi is not a double: the angle is short of half a turn by 1.2e-16.
  const Real limit = 4e-16 * v.norm();
  CHECK(distance(axisAngleToMatrix(Vector3::UnitY(), kPi) * v, turned) <= limit);
  CHECK(distance(rotatePoint(axisAngleToQuaternion(Vector3::UnitY(), kPi), v), turned) <= limit);
  CHECK(rotatePoint({0, 0, 1, 0}, v) == turned);
}

TEST_CASE("a quarter turn about z takes x to y: counter-clockwise, seen from the tip of the axis") {
  CHECK(distance(axisAngleToMatrix(Vector3::UnitZ(), kPi / 2) * Vector3::UnitX(),
                 Vector3::UnitY()) <= 1e-16);
  CHECK(distance(rotatePoint(axisAngleToQuaternion(Vector3::UnitZ(), kPi / 2), Vector3::UnitX()),
                 Vector3::UnitY()) <= 3e-16);
}

TEST_CASE("the matrix of an axis and an angle is Rodrigues' formula") {
  Random random(201);
  for (int i = 0; i < 10000; ++i) {
    const Vector3 axis = random.inBox(1).normalized(), v = random.inBox(1);
    const Real angle = random.between(-7, 7);
    const Vector3 turned = v * std::cos(angle) + cross(axis, v) * std::sin(angle) +
                           axis * axis.dot(v) * (1 - std::cos(angle));
    REQUIRE(distance(axisAngleToMatrix(axis, angle) * v, turned) <= 2e-15);
    REQUIRE(orthogonalityError(axisAngleToMatrix(axis, angle)) <= 2e-15);
  }
}

TEST_CASE("the matrix and the quaternion of an axis and an angle are the same rotation") {
  Random random(202);
  for (int i = 0; i < 10000; ++i) {
    const Vector3 axis = random.inBox(5);
    const Real angle = random.between(-7, 7);
    const Quaternion q = axisAngleToQuaternion(axis, angle);
    REQUIRE(distance(quaternionToMatrix(q), axisAngleToMatrix(axis, angle)) <= 1e-15);
    REQUIRE(std::abs(Real(norm(q) - 1)) <= 3e-16);
  }
}

TEST_CASE("the axis stays where it is") {
  Random random(203);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 axis = random.inBox(1);
    REQUIRE(distance(axisAngleToMatrix(axis, random.between(-9, 9)) * axis, axis) <= 1e-15);
  }
}

TEST_CASE("a turn by a tiny angle keeps all its digits") {
  const Matrix3 R = axisAngleToMatrix(Vector3::UnitZ(), 1e-12);
  CHECK(R(1, 0) == 1e-12);
  CHECK(R(0, 1) == -1e-12);
  CHECK(axisAngleToQuaternion(Vector3::UnitX(), 1e-200).x == 5e-201);
}

TEST_CASE("the length of the axis does not matter, however long or short") {
  const Quaternion q = axisAngleToQuaternion({1, 2, 3}, 1);
  const Matrix3 R = axisAngleToMatrix({1, 2, 3}, 1);
  for (const int e : {-1070, -600, -3, 0, 5, 600, 1020}) {
    const Vector3 axis(std::ldexp(1, e), std::ldexp(2, e), std::ldexp(3, e));
    CHECK(distance(axisAngleToQuaternion(axis, 1), q) == 0);
    CHECK(distance(axisAngleToMatrix(axis, 1), R) == 0);
  }
  CHECK(std::abs(Real(norm(q) - 1)) <= 3e-16);
}

TEST_CASE("an angle of zero is the identity") {
  CHECK(axisAngleToMatrix({0, 0, 3}, 0) == Matrix3::Identity());
  CHECK(distance(axisAngleToQuaternion({0, 0, 3}, 0), {1, 0, 0, 0}) == 0);
}

TEST_CASE("a whole turn more changes the sign of the quaternion and not the rotation") {
  const Quaternion once = axisAngleToQuaternion({1, 2, 3}, 1);
  const Quaternion more = axisAngleToQuaternion({1, 2, 3}, 1 + 2 * kPi);
  CHECK(distance(more, {-once.w, -once.x, -once.y, -once.z}) <= 5e-16);
  CHECK(distance(quaternionToMatrix(once), quaternionToMatrix(more)) <= 1e-15);
}

TEST_CASE("an axis without direction is refused, and the message says why") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real infinite = std::numeric_limits<Real>::infinity();
  CHECK_THROWS_WITH(axisAngleToQuaternion({0, 0, 0}, 1),
                    "axis = (0, 0, 0) must not be zero: it has no direction");
  CHECK_THROWS_AS(axisAngleToMatrix({0, 0, 0}, 1), InvalidInput);
  CHECK_THROWS_AS(axisAngleToMatrix({1, nan, 0}, 1), InvalidInput);
  CHECK_THROWS_AS(axisAngleToQuaternion({infinite, 0, 0}, 1), InvalidInput);
  CHECK_THROWS_WITH(axisAngleToQuaternion({1, 0, 0}, infinite), "angle = inf must be finite");
  CHECK_THROWS_AS(axisAngleToMatrix({1, 0, 0}, nan), InvalidInput);
}
