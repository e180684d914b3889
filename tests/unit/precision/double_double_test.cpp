#include "carom/precision/double_double.hpp"

#include "exact_integers.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace precision_test;

namespace {

// A whole number of up to 106 bits, as high + low that do not overlap.
DoubleDouble wide(std::mt19937_64& engine, int bits) {
  const Real a = whole(engine, bits / 2), b = whole(engine, bits - bits / 2);
  return exactProduct(a, b);
}

bool isNormal(const DoubleDouble& value) {
  return value.high + value.low == value.high;
}

}  // namespace

TEST_CASE("differences and products of doubles are exact") {
  std::mt19937_64 engine(41);
  for (int i = 0; i < 20000; ++i) {
    const Real a = whole(engine, 53), b = std::ldexp(whole(engine, 53), 20);
    REQUIRE(exactly(exactDifference(a, b)) == Integer(a) - Integer(b));
    const Real c = whole(engine, 53);
    REQUIRE(exactly(exactProduct(a, c)) == Integer(a) * Integer(c));
  }
}

TEST_CASE("sums and differences of double-doubles lose at most 3 * 2^-106") {
  std::mt19937_64 engine(42);
  for (int i = 0; i < 50000; ++i) {
    const DoubleDouble a = wide(engine, 106), b = wide(engine, 60 + i % 47);
    const DoubleDouble sum = a + b, difference = a - b;
    const Integer exactSum = exactly(a) + exactly(b), exactGap = exactly(a) - exactly(b);
    REQUIRE(magnitude(exactly(sum) - exactSum) <= 3 * 0x1p-106L * magnitude(exactSum));
    REQUIRE(magnitude(exactly(difference) - exactGap) <= 3 * 0x1p-106L * magnitude(exactGap));
    REQUIRE(isNormal(sum));
    DoubleDouble inPlace = a;
    inPlace += b;
    REQUIRE(exactly(inPlace) == exactly(sum));
  }
}

TEST_CASE("numbers that nearly cancel leave their exact difference") {
  std::mt19937_64 engine(43);
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = wide(engine, 100);
    const Real small = whole(engine, 20);
    REQUIRE(exactly((a + small) - a) == Integer(small));
  }
}

TEST_CASE("products of double-doubles lose at most 7 * 2^-106") {
  std::mt19937_64 engine(44);
  for (int i = 0; i < 50000; ++i) {
    const DoubleDouble a = wide(engine, 63), b = wide(engine, 63);
    const DoubleDouble product = a * b;
    const Integer reference = exactly(a) * exactly(b);
    REQUIRE(magnitude(exactly(product) - reference) <= 7 * 0x1p-106L * magnitude(reference));
    REQUIRE(isNormal(product));
  }
}

TEST_CASE("a quotient times its divisor is the dividend, within 2^-101") {
  std::mt19937_64 engine(45);
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = wide(engine, 100), b = wide(engine, 60);
    if (b.high == 0 || a.high == 0) continue;
    const DoubleDouble gap = (a / b) * b - a;
    REQUIRE(std::abs(gap.high) <= 0x1p-101 * std::abs(a.high));
  }
  const DoubleDouble third = DoubleDouble(1) / 3;
  CHECK(third.high == 1.0 / 3);
  CHECK(third.low == 0x1p-54 / 3);
}

TEST_CASE("a double and a double-double mix in one formula") {
  const DoubleDouble a = DoubleDouble(1) + 0x1p-80;
  CHECK(a.high == 1);
  CHECK(a.low == 0x1p-80);
  CHECK(a.value() == 1);
  CHECK((a * 2).low == 0x1p-79);
  CHECK((-a).low == -0x1p-80);
  CHECK((a - 1).high == 0x1p-80);
}
