#include <limits>

#include "carom/core/errors.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;

namespace {
const Quaternion kOne{1, 0, 0, 0}, kI{0, 1, 0, 0}, kJ{0, 0, 1, 0}, kK{0, 0, 0, 1};
const Quaternion kMinusOne{-1, 0, 0, 0};
}  // namespace

TEST_CASE("i, j and k multiply as Hamilton carved them into the bridge") {
  CHECK(distance(hamiltonProduct(kI, kI), kMinusOne) == 0);
  CHECK(distance(hamiltonProduct(kJ, kJ), kMinusOne) == 0);
  CHECK(distance(hamiltonProduct(kK, kK), kMinusOne) == 0);
  CHECK(distance(hamiltonProduct(hamiltonProduct(kI, kJ), kK), kMinusOne) == 0);
  CHECK(distance(hamiltonProduct(kI, kJ), kK) == 0);
  CHECK(distance(hamiltonProduct(kJ, kK), kI) == 0);
  CHECK(distance(hamiltonProduct(kK, kI), kJ) == 0);
  CHECK(distance(hamiltonProduct(kJ, kI), conjugate(kK)) == 0);
}

TEST_CASE("a product with small integers is exact") {
  CHECK(distance(hamiltonProduct({1, 2, 3, 4}, {5, 6, 7, 8}), {-60, 12, 30, 24}) == 0);
  CHECK(distance(hamiltonProduct({5, 6, 7, 8}, {1, 2, 3, 4}), {-60, 20, 14, 32}) == 0);
}

TEST_CASE("rotations are a group under the Hamilton product") {
  Random random(301);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion a = random.rotation(), b = random.rotation(), c = random.rotation();
    REQUIRE(distance(hamiltonProduct(hamiltonProduct(a, b), c),
                     hamiltonProduct(a, hamiltonProduct(b, c))) <= 1e-15);
    REQUIRE(distance(hamiltonProduct(a, kOne), a) == 0);
    REQUIRE(distance(hamiltonProduct(kOne, a), a) == 0);
    REQUIRE(distance(hamiltonProduct(a, conjugate(a)), kOne) <= 5e-16);
    REQUIRE(std::abs(Real(norm(hamiltonProduct(a, b)) - 1)) <= 1e-15);
    REQUIRE(distance(conjugate(hamiltonProduct(a, b)),
                     hamiltonProduct(conjugate(b), conjugate(a))) <= 5e-16);
  }
}

TEST_CASE("the product q r turns by r first: R(q r) = R(q) R(r)") {
  Random random(302);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion q = random.rotation(), r = random.rotation();
    const Vector3 v = random.inBox(1);
    REQUIRE(distance(quaternionToMatrix(hamiltonProduct(q, r)),
                     quaternionToMatrix(q) * quaternionToMatrix(r)) <= 2e-15);
    REQUIRE(distance(rotatePoint(hamiltonProduct(q, r), v), rotatePoint(q, rotatePoint(r, v))) <=
            3e-15);
  }
}

TEST_CASE("quarter turns about x and y do not commute (R9)") {
  const auto c = caseNamed("R9");
  const Real s = std::sqrt(0.5);
  const Quaternion aboutX{s, s, 0, 0}, aboutY{s, 0, s, 0};
  const Real limit = number(c["accept"]["error"]);
  CHECK(distance(rotatePoint(hamiltonProduct(aboutY, aboutX), Vector3::UnitZ()),
                 vector(c["x then y"])) <= limit);
  CHECK(distance(rotatePoint(hamiltonProduct(aboutX, aboutY), Vector3::UnitZ()),
                 vector(c["y then x"])) <= limit);
}

TEST_CASE("a quaternion of norm 5 turns a point without stretching it (R7)") {
  const auto c = caseNamed("R7");
  const Vector3 turned = rotatePoint(quaternion(c["q"]), vector(c["v"]));
  CHECK(distance(turned, vector(c["turned"])) <= number(c["accept"]["error"]));
}

TEST_CASE("rotations keep lengths and angles, and q and -q are the same one") {
  Random random(303);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion q = random.rotation();
    const Vector3 v = random.inBox(1), w = random.inBox(1);
    const Vector3 turnedV = rotatePoint(q, v), turnedW = rotatePoint(q, w);
    REQUIRE(std::abs(turnedV.norm() - v.norm()) <= 1e-15);
    REQUIRE(std::abs(turnedV.dot(turnedW) - v.dot(w)) <= 3e-15);
    REQUIRE(distance(rotatePoint({-q.w, -q.x, -q.y, -q.z}, v), turnedV) == 0);
    REQUIRE(distance(rotatePoint(conjugate(q), turnedV), v) <= 2e-15);
    REQUIRE(distance(quaternionToMatrix(q) * v, turnedV) <= 1e-15);
  }
}

TEST_CASE("the norm of a quaternion does not matter to a point, from 1e-300 to 1e300") {
  const Vector3 expected = rotatePoint({1, 2, -2, 4}, {1, 0, 0});
  for (const int e : {-1074, -1000, -300, -5, 7, 300, 1000, 1020}) {
    const Quaternion q{std::ldexp(1, e), std::ldexp(2, e), std::ldexp(-2, e), std::ldexp(4, e)};
    CHECK(distance(rotatePoint(q, {1, 0, 0}), expected) == 0);
    CHECK(distance(renormalize(q), renormalize({1, 2, -2, 4})) == 0);
    CHECK(distance(quaternionToMatrix(q), quaternionToMatrix({1, 2, -2, 4})) == 0);
    CHECK(distance(quaternionLogarithm(q), quaternionLogarithm({1, 2, -2, 4})) <= 4e-16);
  }
}

TEST_CASE("renormalising gives norm 1 within 2 ulp and keeps the direction") {
  CHECK(distance(renormalize({1, 2, -2, 4}), {0.2, 0.4, -0.4, 0.8}) <= 1e-16);
  CHECK(distance(renormalize({0, 0, -7, 0}), {0, 0, -1, 0}) == 0);
  Random random(304);
  for (int i = 0; i < 10000; ++i) {
    const Quaternion unit = random.rotation();
    const Real size = std::exp(random.between(-300, 300));
    const Quaternion q = renormalize({unit.w * size, unit.x * size, unit.y * size, unit.z * size});
    REQUIRE(std::abs(Real(norm(q) - 1)) <= 2 * 0x1p-52);
    REQUIRE(distance(q, unit) <= 4e-16);
    REQUIRE(distance(renormalize(q), q) == 0);
  }
}

TEST_CASE("a quaternion that stands for no rotation is refused by name") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real infinite = std::numeric_limits<Real>::infinity();
  CHECK_THROWS_WITH(renormalize({0, 0, 0, 0}),
                    "q = (0, 0, 0, 0) must not be zero: it is no rotation");
  CHECK_THROWS_AS(rotatePoint({0, 0, 0, 0}, {1, 0, 0}), InvalidInput);
  CHECK_THROWS_WITH(rotatePoint({1, nan, 0, 0}, {1, 0, 0}), "q = (1, nan, 0, 0) must be finite");
  CHECK_THROWS_AS(quaternionToMatrix({0, infinite, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(quaternionLogarithm({0, 0, 0, 0}), InvalidInput);
}

TEST_CASE("a product hands on what is not a number") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK(std::isnan(hamiltonProduct({nan, 0, 0, 0}, {1, 0, 0, 0}).w));
}
