#include "carom/core/quarter_turns.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include "carom/core/two_sum.hpp"

namespace carom {
namespace {

constexpr Real kTwoOverPi = 0x1.45f306dc9c883p-1;
constexpr Real kHalfPi = 0x1.921fb54442d18p+0, kHalfPiRest = 0x1.1a62633145c07p-54;

// pi/2 in three parts of 33 bits and a rest. Times a number below 2^20 the parts are exact.
constexpr Real kPart1 = 0x1.921fb54400000p+0;
constexpr Real kPart2 = 0x1.0b4611a600000p-34;
constexpr Real kPart3 = 0x1.3198a2e000000p-69;
constexpr Real kPart4 = 0x1.b839a252049c1p-104;
constexpr Real kLargestSplit = 0x1p20;  // [rad]: up to here fewer than 2^20 quarter turns

// The first 1216 bits of 2/pi after the binary point, behind 64 zero bits, in words of 32.
constexpr int kPadding = 64;
constexpr std::array<std::uint32_t, 40> kTwoOverPiBits = {
    0,          0,          0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041,
    0xfe5163ab, 0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e,
    0xe88235f5, 0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b,
    0x1ff897ff, 0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d,
    0x7527bac7, 0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab,
};

QuarterTurns bySplitting(Real angle) {
  const int k = static_cast<int>(angle * kTwoOverPi + (angle < 0 ? -0.5 : 0.5));
  const Real turns = k;
  const Real coarse = angle - turns * kPart1;  // exact: product and difference
  const TwoSum second = twoSum(coarse, -turns * kPart2);
  const TwoSum third = twoSum(second.sum, -turns * kPart3);
  const TwoSum rest = twoSum(third.sum, (second.error + third.error) - turns * kPart4);
  return {k & 3, rest.sum, rest.error};
}

// angle = m 2^e with a 53-bit integer m. What counts is the fraction of angle / (2 pi), so of 2/pi
// 2^e / 4 only the bits behind the point: 192 of them leave an error of 2^53 2^-192 turns, while no
// double comes closer to a multiple of a quarter turn than 2^-62.
QuarterTurns byIntegers(Real angle) {
  int exponent = 0;
  const Real fraction = std::frexp(std::abs(angle), &exponent);
  const auto m = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int first = kPadding + (exponent - 53) - 2;  // position of the first bit behind the point

  constexpr int kWords = 6;
  std::array<std::uint32_t, kWords> turn{};  // most significant word first
  for (int i = 0; i < kWords; ++i) {
    const int word = first / 32 + i, shift = first % 32;
    const std::uint64_t pair = std::uint64_t{kTwoOverPiBits[word]} << 32 | kTwoOverPiBits[word + 1];
    turn[i] = static_cast<std::uint32_t>(pair << shift >> 32);
  }

  // Times m, modulo one whole turn: carries out of the first word are dropped.
  const std::uint64_t mLow = m & 0xffffffffu, mHigh = m >> 32;
  std::array<std::uint32_t, kWords> product{};
  std::uint64_t carryLow = 0, carryHigh = 0;
  for (int i = kWords - 1; i >= 0; --i) {
    const std::uint64_t low = turn[i] * mLow + carryLow;
    carryLow = low >> 32;
    const std::uint64_t shifted = i + 1 < kWords ? turn[i + 1] * mHigh : 0;
    const std::uint64_t sum = (low & 0xffffffffu) + (shifted & 0xffffffffu) + carryHigh;
    product[i] = static_cast<std::uint32_t>(sum);
    carryHigh = (sum >> 32) + (shifted >> 32);
  }

  // Two bits of quarter turns; the others, read as a signed number, are the rest, rounded to
  // nearest.
  auto quarters = static_cast<int>(product[0] >> 30);
  for (int i = 0; i < kWords; ++i) {
    product[i] = product[i] << 2 | (i + 1 < kWords ? product[i + 1] >> 30 : 0);
  }
  const bool negative = (product[0] >> 31) != 0;
  if (negative) {
    ++quarters;
    std::uint64_t carry = 1;
    for (int i = kWords - 1; i >= 0; --i) {
      carry += static_cast<std::uint32_t>(~product[i]);
      product[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }

  Real high = 0, low = 0;  // of a quarter turn
  for (int i = kWords - 1; i >= 0; --i) {
    const TwoSum next = twoSum(std::ldexp(Real(product[i]), -32 * (i + 1)), high);
    high = next.sum;
    low += next.error;
  }
  const TwoProduct scaled = twoProduct(high, kHalfPi);
  const TwoSum rest = twoSum(scaled.product, scaled.error + (high * kHalfPiRest + low * kHalfPi));

  if (negative != (angle < 0))
    return {(angle < 0 ? -quarters : quarters) & 3, -rest.sum, -rest.error};
  return {(angle < 0 ? -quarters : quarters) & 3, rest.sum, rest.error};
}

}  // namespace

QuarterTurns quarterTurns(Real angle) {
  const Real size = std::abs(angle);
  if (size <= kHalfPi / 2) return {0, angle, 0};
  if (size < kLargestSplit) return bySplitting(angle);
  if (std::isfinite(angle)) return byIntegers(angle);
  return {0, angle - angle, 0};  // infinity - infinity is not a number
}

}  // namespace carom
