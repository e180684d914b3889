// Doubles that are whole numbers are checked against integers of 128 bits, which are exact.

#include "carom/core/two_sum.hpp"

#include <cstdint>
#include <random>

#include "support/catch.hpp"

using namespace carom;

namespace {

__extension__ using Integer = __int128;

// A whole number of up to 53 bits times a power of two.
Real whole(std::mt19937_64& engine, int maxExponent) {
  const auto bits = static_cast<std::int64_t>(engine() >> 11) - (std::int64_t{1} << 52);
  return std::ldexp(static_cast<Real>(bits), static_cast<int>(engine() % (maxExponent + 1)));
}

}  // namespace

TEST_CASE("a sum and its error are the exact sum") {
  std::mt19937_64 engine(21);
  for (int i = 0; i < 100000; ++i) {
    const Real a = whole(engine, 60), b = whole(engine, 60);
    const TwoSum s = twoSum(a, b);
    REQUIRE(s.sum == a + b);
    REQUIRE(Integer(s.sum) + Integer(s.error) == Integer(a) + Integer(b));
    const Real large = std::abs(a) > std::abs(b) ? a : b, small = large == a ? b : a;
    const TwoSum fast = fastTwoSum(large, small);
    REQUIRE(fast.sum == s.sum);
    REQUIRE(fast.error == s.error);
  }
}

TEST_CASE("a product and its error are the exact product") {
  std::mt19937_64 engine(22);
  for (int i = 0; i < 100000; ++i) {
    const Real a = whole(engine, 8), b = whole(engine, 8);
    const TwoProduct p = twoProduct(a, b);
    REQUIRE(p.product == a * b);
    REQUIRE(Integer(p.product) + Integer(p.error) == Integer(a) * Integer(b));
  }
}

TEST_CASE("the error is what rounding lost, and zero where nothing was lost") {
  CHECK(twoSum(1, 0x1p-60).sum == 1);
  CHECK(twoSum(1, 0x1p-60).error == 0x1p-60);
  CHECK(twoSum(0x1p-60, 1).error == 0x1p-60);  // the order does not matter
  CHECK(twoSum(0.5, 0.25).error == 0);
  CHECK(twoSum(0.1, 0.2).error == -2.7755575615628914e-17);
  CHECK(twoProduct(3, 7).error == 0);
  CHECK(twoProduct(1 + 0x1p-52, 1 - 0x1p-52).product == 1);
  CHECK(twoProduct(1 + 0x1p-52, 1 - 0x1p-52).error == -0x1p-104);
}

TEST_CASE("error-free products hold over the whole range that is promised") {
  const Real a = 1 + 0x1p-52, b = 1 - 0x1p-52;  // a b = 1 - 2^-104
  for (int e = -425; e <= 495; e += 5) {
    const TwoProduct p = twoProduct(std::ldexp(a, e), std::ldexp(b, e));
    REQUIRE(p.product == std::ldexp(1, 2 * e));
    REQUIRE(p.error == -std::ldexp(1, 2 * e - 104));
  }
}
