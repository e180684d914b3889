#include <limits>

#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/slerp.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;

TEST_CASE("slerp finds the orientation of case R9") {
  const auto c = caseNamed("R9");
  const auto s = c["slerp"];
  const Quaternion a = axisAngleToQuaternion(vector(s["a"]["axis"]), number(s["a"]["angle"]));
  const Quaternion b = axisAngleToQuaternion(vector(s["b"]["axis"]), number(s["b"]["angle"]));
  CHECK(distance(slerp(a, b, number(s["t"])), quaternion(s["q"])) <= number(c["accept"]["error"]));
  CHECK(std::abs(quaternionLogarithm(hamiltonProduct(conjugate(a), b)).norm() -
                 number(s["angle"])) <= 1e-15);
}

TEST_CASE("slerp starts at a and ends at b, the same rotation if not the same sign") {
  Random random(601);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion a = random.rotation(), b = random.rotation();
    REQUIRE(distance(slerp(a, b, 0), a) <= 4e-16);
    REQUIRE(distanceOfRotations(slerp(a, b, 1), b) <= 4e-16);
  }
}

TEST_CASE("slerp walks the short way at constant speed: a exp(t log(a* b))") {
  Random random(602);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion a = random.rotation(), b = random.rotation();
    const Real t = random.between(0, 1);
    const Vector3 way = quaternionLogarithm(hamiltonProduct(conjugate(a), b));
    REQUIRE(way.norm() <= kPi);
    REQUIRE(distanceOfRotations(slerp(a, b, t),
                                hamiltonProduct(a, quaternionExponential(t * way))) <= 1e-14);
    REQUIRE(std::abs(angleBetween(a, slerp(a, b, t)) - t * way.norm()) <= 3e-15);
  }
}

TEST_CASE("slerp gives the same rotation for b and -b, and the same way back") {
  Random random(603);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion a = random.rotation(), b = random.rotation();
    const Quaternion minusB{-b.w, -b.x, -b.y, -b.z};
    REQUIRE(distance(slerp(a, b, 0.3), slerp(a, minusB, 0.3)) == 0);
    REQUIRE(distanceOfRotations(slerp(a, b, 0.25), slerp(b, a, 0.75)) <= 1e-15);
  }
}

TEST_CASE("between orientations that are very close slerp keeps all its digits") {
  for (const Real angle : {1e-3, 1e-8, 1e-15, 1e-100, 0.0}) {
    const Quaternion a, b = axisAngleToQuaternion(Vector3::UnitX(), angle);
    const Quaternion q = slerp(a, b, 0.5);
    CHECK(std::abs(q.x - std::sin(angle / 4)) <= 1e-16 * angle);
    CHECK(q.w == carom_test::Approx(1));
  }
}

TEST_CASE("from an orientation to itself slerp stays there, with either sign") {
  const Quaternion a{0.5, -0.5, 0.5, 0.5};
  CHECK(distance(slerp(a, a, 0.7), a) == 0);
  CHECK(distance(slerp(a, {-0.5, 0.5, -0.5, -0.5}, 0.7), a) == 0);
}

TEST_CASE("at exactly half a turn slerp goes to b as it is given") {
  CHECK(distance(slerp({1, 0, 0, 0}, {0, 0, 0, 1}, 0.5), {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}) <=
        2e-16);
  CHECK(distance(slerp({1, 0, 0, 0}, {0, 0, 0, -1}, 0.5),
                 {std::sqrt(0.5), 0, 0, -std::sqrt(0.5)}) <= 2e-16);
}

TEST_CASE("slerp goes on turning outside 0 and 1") {
  const Quaternion a, b = axisAngleToQuaternion({1, 1, 0}, 0.5);
  CHECK(distance(slerp(a, b, 3), axisAngleToQuaternion({1, 1, 0}, 1.5)) <= 1e-15);
  CHECK(distance(slerp(a, b, -2), axisAngleToQuaternion({1, 1, 0}, -1)) <= 1e-15);
}

TEST_CASE("slerp takes orientations of any norm, but not of none") {
  const Quaternion a{1, 0, 0, 0}, b{0.6, 0.8, 0, 0};
  CHECK(distance(slerp({1e-200, 0, 0, 0}, {6e150, 8e150, 0, 0}, 0.4), slerp(a, b, 0.4)) <= 3e-16);
  CHECK_THROWS_AS(slerp({0, 0, 0, 0}, b, 0.5), InvalidInput);
  CHECK_THROWS_AS(slerp(a, {0, 0, 0, 0}, 0.5), InvalidInput);
  CHECK_THROWS_WITH(slerp(a, b, std::numeric_limits<Real>::quiet_NaN()),
                    carom_test::ContainsSubstring("t = nan must be finite") ||
                        carom_test::ContainsSubstring("t = -nan must be finite"));
}
