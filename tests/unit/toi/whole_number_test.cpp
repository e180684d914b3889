// Whole numbers of any size against 128-bit integers, identities, and doubles.

#include <cmath>
#include <limits>

#include "carom/core/random.hpp"
#include "carom/toi/whole_number.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

__extension__ using Integer = __int128;

// A double of up to `bits` bits, of either sign; now and then with long rows of ones or zeros.
Real someNumber(Random& random, int bits) {
  const Real size = std::ldexp(1.0, bits);
  switch (random.integer(0, 3)) {
    case 0:
      return std::trunc(random.between(-size, size));
    case 1:
      return size - random.integer(0, 2);
    case 2:
      return -(size / 2) + random.integer(-1, 1);
    default:
      return random.integer(-2, 2);
  }
}

WholeNumber whole(Real value) {
  return WholeNumber::inUnits(value, 0);
}

// A number of many digits.
WholeNumber longNumber(Random& random, int digits) {
  WholeNumber sum;
  for (int i = 0; i < digits; ++i) {
    sum <<= random.integer(1, 70);
    sum += whole(someNumber(random, 53));
  }
  return sum;
}

bool isSame(const WholeNumber& a, const WholeNumber& b) {
  return (a - b).sign() == 0 && a.bits() == b.bits() && a.sign() == b.sign();
}

}  // namespace

TEST_CASE("whole numbers add, subtract and multiply as 128-bit integers do") {
  Random random(11);
  for (int i = 0; i < 20000; ++i) {
    const Real a = someNumber(random, 53), b = someNumber(random, 53), c = someNumber(random, 20);
    const Integer expected = Integer(a) * Integer(b) - Integer(c) * Integer(a) + Integer(b);
    const WholeNumber result = whole(a) * whole(b) - whole(c) * whole(a) + whole(b);
    REQUIRE(result.sign() == (expected > 0) - (expected < 0));
    // The same digits: both halves as whole numbers.
    const Integer size = expected < 0 ? -expected : expected;
    WholeNumber high = whole(static_cast<Real>(static_cast<std::uint64_t>(size >> 60)));
    REQUIRE(static_cast<Integer>(high.towardsZero(0)) == size >> 60);
    high <<= 60;
    const auto low = static_cast<std::uint64_t>(size) & ((std::uint64_t(1) << 60) - 1);
    high += whole(static_cast<Real>(low >> 30)) * whole(0x1p30);
    high += whole(static_cast<Real>(low & 0x3fffffff));
    REQUIRE(isSame(expected < 0 ? WholeNumber() - high : high, result));
  }
}

TEST_CASE("long whole numbers obey the laws of algebra") {
  Random random(12);
  for (int i = 0; i < 2000; ++i) {
    const WholeNumber a = longNumber(random, random.integer(0, 12));
    const WholeNumber b = longNumber(random, random.integer(0, 12));
    const WholeNumber c = longNumber(random, random.integer(0, 4));
    REQUIRE(isSame((a + b) * (a - b), a * a - b * b));
    REQUIRE(isSame((a + b) * c, c * a + c * b));
    REQUIRE(isSame((a * b) * c, a * (b * c)));
    REQUIRE(((a + b) - b - a).sign() == 0);
    const int shift = random.integer(0, 200);
    WholeNumber shifted = a, power = 1;
    shifted <<= shift;
    power <<= shift;
    REQUIRE(isSame(shifted, a * power));
    REQUIRE(shifted.bits() == (a.sign() == 0 ? 0 : a.bits() + shift));
  }
}

TEST_CASE("a double survives the way into whole numbers and back, at any size") {
  Random random(13);
  const Real least = std::numeric_limits<Real>::denorm_min();
  const Real most = std::numeric_limits<Real>::max();
  for (const Real value : {0.0, 1.0, -1.0, 0.1, -1e-300, 1e300, least, -3 * least, most, -most}) {
    CHECK(WholeNumber::inUnits(value, -1074).towardsZero(1074) == value);
  }
  for (int i = 0; i < 5000; ++i) {
    const Real value = random.between(-1, 1) * std::pow(2.0, random.integer(-300, 300));
    REQUIRE(WholeNumber::inUnits(value, -1074).towardsZero(1074) == value);
  }
}

TEST_CASE("digits that do not fit into a double are cut off, not rounded") {
  WholeNumber n = whole(0x1p53);
  n <<= 10;
  n += whole(1023);  // 1 - 2^-10 of the last place: rounding to nearest would go up
  CHECK(n.towardsZero(0) == 0x1p63);
  CHECK((WholeNumber() - n).towardsZero(0) == -0x1p63);
  CHECK(whole(3).towardsZero(1075) == std::numeric_limits<Real>::denorm_min());
  CHECK(whole(1).towardsZero(1075) == 0);
}
