#include <cmath>
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/precision/float_bits.hpp"
#include "carom/precision/float_ulp_distance.hpp"
#include "carom/precision/ulp.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
}  // namespace

TEST_CASE("the bits of known numbers") {
  CHECK(bitText(bitsOf(1.0f)) == "0 01111111 00000000000000000000000");
  CHECK(bitText(bitsOf(-0.0f)) == "1 00000000 00000000000000000000000");
  CHECK(bitText(bitsOf(0.1f)) == "0 01111011 10011001100110011001101");
  CHECK(bitText(bitsOf(-2.5)) ==
        "1 10000000000 0100000000000000000000000000000000000000000000000000");
  CHECK(bitsOf(0.15625f).exponent == -3);
  CHECK(bitsOf(0.15625f).fraction == 1u << 21);
}

TEST_CASE("every kind of number is recognised, in both sizes") {
  CHECK(bitsOf(0.0f).kind == NumberKind::zero);
  CHECK(bitsOf(0x1p-126f).kind == NumberKind::normal);
  CHECK(bitsOf(0x1p-127f).kind == NumberKind::subnormal);
  CHECK(bitsOf(0x1p-149f).kind == NumberKind::subnormal);
  CHECK(bitsOf(0x1p-126f).exponent == -126);
  CHECK(bitsOf(0x1p-149f).exponent == -126);
  CHECK(bitsOf(kFloatInfinity).kind == NumberKind::infinite);
  CHECK(bitsOf(std::numeric_limits<float>::quiet_NaN()).kind == NumberKind::notANumber);
  CHECK(bitsOf(0x1p-1022).kind == NumberKind::normal);
  CHECK(bitsOf(0x1p-1023).kind == NumberKind::subnormal);
  CHECK(bitsOf(-kInfinity).kind == NumberKind::infinite);
  CHECK(bitsOf(std::numeric_limits<Real>::quiet_NaN()).kind == NumberKind::notANumber);
  CHECK(std::string(kindName(NumberKind::subnormal)) == "subnormal");
}

TEST_CASE("a number taken apart and put together again is itself") {
  Random random(71);
  for (int i = 0; i < 20000; ++i) {
    const auto x = std::bit_cast<Real>(random.bits());
    const auto y = std::bit_cast<float>(static_cast<std::uint32_t>(random.bits()));
    if (!std::isnan(x)) REQUIRE(valueOf(bitsOf(x)) == x);
    if (!std::isnan(y)) REQUIRE(valueOf(bitsOf(y)) == Real(y));
  }
  for (const Real x : {0.0, 5e-324, 0x1p-1022, kInfinity, -1e308}) CHECK(valueOf(bitsOf(x)) == x);
  CHECK(std::signbit(valueOf(bitsOf(-0.0))));
  CHECK(std::isnan(valueOf(bitsOf(std::numeric_limits<float>::quiet_NaN()))));
}

TEST_CASE("the spacing doubles at each power of two, and is even among the subnormals") {
  CHECK(ulp(1.0) == 0x1p-52);
  CHECK(ulp(-1.999) == 0x1p-52);
  CHECK(ulp(2.0) == 0x1p-51);
  CHECK(ulp(1.0f) == 0x1p-23f);
  CHECK(ulp(0.0) == 5e-324);
  CHECK(ulp(0x1p-1030) == 5e-324);
  CHECK(ulp(0.0f) == 0x1p-149f);
  CHECK(ulp(std::numeric_limits<Real>::max()) == 0x1p971);
  CHECK(ulp(std::numeric_limits<float>::max()) == 0x1p104f);
  CHECK(std::isnan(ulp(kInfinity)));
  CHECK(std::isnan(ulp(std::numeric_limits<Real>::quiet_NaN())));
}

TEST_CASE("neighbouring floats are one apart, whatever their size and sign") {
  for (const float x : {1.0f, -1.0f, 1e-30f, 0x1p-149f, -1e38f, 0.0f, 0x1p24f}) {
    CHECK(floatUlpDistance(x, x) == 0);
    CHECK(floatUlpDistance(x, std::nextafter(x, kFloatInfinity)) == 1);
    CHECK(floatUlpDistance(x, std::nextafter(x, -kFloatInfinity)) == 1);
  }
  CHECK(floatUlpDistance(1, 2) == 1u << 23);
  CHECK(floatUlpDistance(0.0f, -0.0f) == 0);
  CHECK(floatUlpDistance(0x1p-149f, -0x1p-149f) == 2);
  CHECK(floatUlpDistance(-kFloatInfinity, kFloatInfinity) == 2 * (0xffu << 23));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK_THROWS_AS(floatUlpDistance(1, nan), InvalidInput);
  CHECK_THROWS_WITH(floatUlpDistance(nan, 1), "a = nan must be a number");
}
