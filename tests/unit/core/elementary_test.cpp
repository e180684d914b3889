// The references are the C library's functions in long double, which carry 11 more bits, and a few
// values computed with a thousand digits.

#include "carom/core/elementary.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "carom/core/quarter_turns.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kPi = 3.14159265358979323846;

// The error of a value in units in the last place of the exact one.
Real ulps(Real value, long double exact) {
  int e = 0;
  std::frexp(static_cast<Real>(exact), &e);
  return static_cast<Real>(std::abs(value - exact) / std::ldexp(1.0L, std::max(e - 53, -1074)));
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  Real between(Real low, Real high) {
    return low + (high - low) * (static_cast<Real>(engine_() >> 11) * 0x1p-53);
  }
  Real anyFinite() {
    for (;;) {
      const auto value = std::bit_cast<Real>(engine_());
      if (std::isfinite(value)) return value;
    }
  }

 private:
  std::mt19937_64 engine_;
};

std::uint64_t hashed(std::uint64_t hash, Real value) {
  return (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;  // FNV-1a, a word at a time
}

constexpr std::uint64_t kEmptyHash = 0xcbf29ce484222325u;

}  // namespace

TEST_CASE("sine and cosine are within an ulp up to a million radians") {
  Random random(11);
  for (const Real size : {0.8, 3.2, 100.0, 1e5, 1.04e6}) {
    for (int i = 0; i < 40000; ++i) {
      const Real x = random.between(-size, size);
      INFO("x = " << x);
      REQUIRE(ulps(sine(x), std::sin(static_cast<long double>(x))) < 0.9);
      REQUIRE(ulps(cosine(x), std::cos(static_cast<long double>(x))) < 0.9);
    }
  }
}

TEST_CASE("sine and cosine are within an ulp for doubles of any size") {
  Random random(12);
  for (int i = 0; i < 40000; ++i) {
    const Real x = random.anyFinite();
    INFO("x = " << x);
    REQUIRE(ulps(sine(x), std::sin(static_cast<long double>(x))) < 0.9);
    REQUIRE(ulps(cosine(x), std::cos(static_cast<long double>(x))) < 0.9);
  }
}

TEST_CASE("next to multiples of a quarter turn, where nearly all digits cancel, none is lost") {
  for (int i = 1; i < 40000; ++i) {
    const Real x = i * (kPi / 2);
    INFO("x = " << x);
    REQUIRE(ulps(sine(x), std::sin(static_cast<long double>(x))) < 0.9);
    REQUIRE(ulps(cosine(x), std::cos(static_cast<long double>(x))) < 0.9);
  }
  // The double closest to a multiple of pi/2 of all (Muller, Elementary Functions).
  const Real worst = std::ldexp(6381956970095103.0, 797);
  CHECK(cosine(worst) == -4.6871659242546276111e-19);
  CHECK(sine(worst) == 1);
}

TEST_CASE("the two ways of reducing an angle agree where one takes over from the other") {
  for (Real x = 0x1p20 - 50; x < 0x1p20 + 50; x += 0.0078125) {
    REQUIRE(ulps(sine(x), std::sin(static_cast<long double>(x))) < 0.9);
    REQUIRE(ulps(cosine(x), std::cos(static_cast<long double>(x))) < 0.9);
  }
}

TEST_CASE("an angle is quarter turns and a rest") {
  CHECK(quarterTurns(0.5).quarters == 0);
  CHECK(quarterTurns(0.5).high == 0.5);
  CHECK(quarterTurns(2).quarters == 1);
  CHECK(quarterTurns(-2).quarters == 3);
  CHECK(quarterTurns(3).quarters == 2);
  CHECK(quarterTurns(6).quarters == 0);
  // pi as a double is short of pi by 1.22e-16, which is all that is left.
  CHECK(quarterTurns(kPi).high == -1.2246467991473532e-16);
  Random random(13);
  for (int i = 0; i < 20000; ++i) {
    const QuarterTurns turns = quarterTurns(random.anyFinite());
    REQUIRE(turns.quarters >= 0);
    REQUIRE(turns.quarters <= 3);
    REQUIRE(std::abs(turns.high) <= 0.78539816339744840);
    REQUIRE(std::abs(turns.low) <= std::abs(turns.high) * 0x1p-53);
  }
}

TEST_CASE("sine is odd and cosine is even, to the last bit") {
  Random random(14);
  for (int i = 0; i < 20000; ++i) {
    const Real x = i % 2 == 0 ? random.between(-1e5, 1e5) : random.anyFinite();
    REQUIRE(sine(-x) == -sine(x));
    REQUIRE(cosine(-x) == cosine(x));
    REQUIRE(sineCosine(x).sine == sine(x));
    REQUIRE(sineCosine(x).cosine == cosine(x));
  }
}

TEST_CASE("at zero sine and arctangent are exact and keep its sign") {
  CHECK(sine(0) == 0);
  CHECK_FALSE(std::signbit(sine(0.0)));
  CHECK(std::signbit(sine(-0.0)));
  CHECK(cosine(0) == 1);
  CHECK(cosine(-0.0) == 1);
  CHECK(arctangent(0) == 0);
  CHECK(std::signbit(arctangent(-0.0)));
  for (const Real tiny : {5e-324, 2e-310, 1e-200, 1e-12}) {
    CHECK(sine(tiny) == tiny);
    CHECK(cosine(tiny) == 1);
    CHECK(arctangent(-tiny) == -tiny);
  }
}

TEST_CASE("the sine of infinity is not a number") {
  CHECK(std::isnan(sine(kInfinity)));
  CHECK(std::isnan(cosine(-kInfinity)));
  CHECK(std::isnan(sine(kNan)));
  CHECK(std::isnan(cosine(kNan)));
  CHECK(std::isnan(sineCosine(kInfinity).cosine));
}

TEST_CASE("the arctangent is within an ulp for tangents of any size") {
  Random random(15);
  for (int i = 0; i < 100000; ++i) {
    const Real x = i % 2 == 0 ? std::ldexp(random.between(-2, 2), i % 60 - 30) : random.anyFinite();
    INFO("x = " << x);
    REQUIRE(ulps(arctangent(x), std::atan(static_cast<long double>(x))) < 0.9);
    REQUIRE(arctangent(-x) == -arctangent(x));
  }
  CHECK(arctangent(1) == kPi / 4);
  CHECK(arctangent(kInfinity) == kPi / 2);
  CHECK(arctangent(-kInfinity) == -kPi / 2);
  CHECK(std::isnan(arctangent(kNan)));
}

TEST_CASE("the arctangent is within an ulp at the joints of its table") {
  for (int k = 0; k <= 33; ++k) {
    Real x = k / 32.0;
    for (int i = 0; i < 8; ++i) x = std::nextafter(x, -1);
    for (int i = 0; i < 16; ++i, x = std::nextafter(x, 2)) {
      REQUIRE(ulps(arctangent(x), std::atan(static_cast<long double>(x))) < 0.9);
    }
  }
}

TEST_CASE("the angle of a point is within an ulp, all around and at any distance") {
  Random random(16);
  for (int i = 0; i < 100000; ++i) {
    Real y = random.between(-1, 1), x = random.between(-1, 1);
    if (i % 2 == 1) {
      y = random.anyFinite();
      x = random.anyFinite();
    }
    INFO("y = " << y << ", x = " << x);
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    REQUIRE(ulps(arctangent2(y, x), exact) < 0.9);
  }
}

TEST_CASE("zeros, infinities and their signs have the angles that IEEE 754 gives them") {
  const Real special[] = {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity, 5e-324, -5e-324, 1e308};
  for (const Real y : special) {
    for (const Real x : special) {
      INFO("y = " << y << ", x = " << x);
      const Real expected = std::atan2(y, x);
      CHECK(std::abs(arctangent2(y, x) - expected) <= std::abs(expected) * 0x1p-52);
      CHECK(std::signbit(arctangent2(y, x)) == std::signbit(expected));
    }
    CHECK(std::isnan(arctangent2(y, kNan)));
    CHECK(std::isnan(arctangent2(kNan, y)));
  }
}

TEST_CASE("sine, cosine and arctangent have the same bits on every machine") {
  // Hashes of the bits over fixed grids. If one of these changes, every recorded simulation
  // changes.
  std::uint64_t sines = kEmptyHash, cosines = kEmptyHash, arctangents = kEmptyHash;
  for (int i = -50000; i <= 50000; ++i) {
    const Real x = i * 0.0017 + Real(i) * std::abs(i) * 1e-5;
    sines = hashed(sines, sine(x));
    cosines = hashed(cosines, cosine(x));
    arctangents = hashed(arctangents, arctangent2(x, 1 + 0.01 * i));
  }
  for (int e = -1070; e < 1023; ++e) {
    const Real x = std::ldexp(1.2345678901234567, e);
    sines = hashed(sines, sine(x));
    cosines = hashed(cosines, cosine(x));
    arctangents = hashed(arctangents, arctangent(x));
  }
  CHECK(sines == 0x3adac51aae7740ecu);
  CHECK(cosines == 0x364b2cc599d932c3u);
  CHECK(arctangents == 0x6b862f703648332du);
}
