#include <limits>

#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;

TEST_CASE("exponential and logarithm of tiny angles keep all their digits (R4)") {
  const auto c = caseNamed("R4");
  const Vector3 axis = vector(c["axis times 3"]) / 3;
  for (std::size_t i = 0; i < c["angles"].size(); ++i) {
    const Real angle = number(c["angles"][i]);
    const Quaternion q = quaternionExponential(angle * axis);
    const Vector3 found = quaternionLogarithm(q);
    INFO("angle " << angle);
    CHECK(std::abs(found.norm() / angle - 1) <= number(c["accept"]["relative error"]));
    CHECK(distance(found, angle * axis) <= 5e-16 * angle);
    CHECK(std::abs((1 - q.w) - number(c["1 - w"][i])) <= 1.2e-16);
  }
}

TEST_CASE("the exponential agrees with axis and angle") {
  Random random(401);
  for (int i = 0; i < 10000; ++i) {
    const Vector3 v = random.inBox(10);
    REQUIRE(distance(quaternionExponential(v), axisAngleToQuaternion(v, v.norm())) <= 5e-16);
  }
}

TEST_CASE("the exponential is right on both sides of the switch to its series") {
  // sin(a/2) in long double is another road with 11 more bits.
  const Real atSwitch = 0x1p-11;
  for (Real angle = atSwitch * (1 - 1e-3); angle < atSwitch * (1 + 1e-3);
       angle += atSwitch * 1e-6) {
    const Quaternion q = quaternionExponential({0, angle, 0});
    const long double exact = std::sin(static_cast<long double>(angle) / 2);
    REQUIRE(std::abs(q.y - exact) <= 2.4e-16L * exact);
  }
  const Quaternion below = quaternionExponential({0, std::nextafter(atSwitch, 0), 0});
  const Quaternion above = quaternionExponential({0, atSwitch, 0});
  CHECK(std::abs(above.y - below.y) <= 2 * 0x1p-64);  // 2 ulp of 2^-12
}

TEST_CASE("the zero vector is the identity, and so are vectors too short to be felt") {
  CHECK(distance(quaternionExponential({0, 0, 0}), {1, 0, 0, 0}) == 0);
  const Quaternion q = quaternionExponential({1e-300, -1e-200, 4e-320});
  CHECK(q.w == 1);
  CHECK(q.x == 5e-301);
  CHECK(q.y == -5e-201);
  CHECK(q.z == 2e-320);
}

TEST_CASE("the exponential has norm 1 for vectors of any length") {
  Random random(402);
  for (int i = 0; i < 10000; ++i) {
    const Vector3 direction = random.inBox(1);
    const Vector3 v = direction * std::exp(random.between(-40, 40));
    REQUIRE(std::abs(Real(norm(quaternionExponential(v)) - 1)) <= 4.5e-16);
  }
}

TEST_CASE("the logarithm undoes the exponential up to half a turn") {
  Random random(403);
  for (int i = 0; i < 20000; ++i) {
    const Vector3 axis = random.inBox(1).normalized();
    const Vector3 v = axis * random.between(0, kPi);
    REQUIRE(distance(quaternionLogarithm(quaternionExponential(v)), v) <= 2e-15);
  }
}

TEST_CASE("the exponential undoes the logarithm") {
  Random random(404);
  for (int i = 0; i < 20000; ++i) {
    const Quaternion q = random.rotation();
    REQUIRE(distanceOfRotations(quaternionExponential(quaternionLogarithm(q)), q) <= 7e-16);
  }
}

TEST_CASE("the logarithm takes the short way: q and -q have the same one") {
  const Vector3 v = quaternionLogarithm(quaternionExponential({0, 0, 4}));
  CHECK(distance(v, Vector3(0, 0, 4 - 2 * kPi)) <= 1e-15);
  Random random(405);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion q = random.rotation();
    REQUIRE(quaternionLogarithm(q) == quaternionLogarithm({-q.w, -q.x, -q.y, -q.z}));
    REQUIRE(quaternionLogarithm(q).norm() <= kPi);
  }
  CHECK(distance(quaternionLogarithm({0, 0, 1, 0}), Vector3(0, kPi, 0)) == 0);
  CHECK(quaternionLogarithm({-1, 0, 0, 0}) == Vector3::Zero());
}

TEST_CASE("exponentials about one axis add up") {
  const Vector3 axis = Vector3(1, -2, 2) / 3;
  const Quaternion both =
      hamiltonProduct(quaternionExponential(0.75 * axis), quaternionExponential(1.5 * axis));
  CHECK(distance(both, quaternionExponential(2.25 * axis)) <= 3e-16);
}

TEST_CASE("a rotation vector without a length is refused") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real largest = std::numeric_limits<Real>::max();
  CHECK_THROWS_AS(quaternionExponential({nan, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(quaternionExponential({largest, largest, 0}), InvalidInput);
  CHECK(std::abs(Real(norm(quaternionExponential({1e300, 1e299, -1e300})) - 1)) <= 4.5e-16);
}
