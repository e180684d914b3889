#include "carom/core/elementary.hpp"

#include <array>
#include <cmath>

#include "carom/core/quarter_turns.hpp"
#include "carom/core/two_sum.hpp"

namespace carom {
namespace {

constexpr Real kPi = 0x1.921fb54442d18p+1, kPiRest = 0x1.1a62633145c07p-53;
constexpr Real kHalfPi = 0x1.921fb54442d18p+0, kHalfPiRest = 0x1.1a62633145c07p-54;

// Below this size x^3/6 is less than a quarter ulp of x, and sin x = x. Also keeps the sign of
// zero.
constexpr Real kTiny = 0x1p-27;

// sin(x + low) for |x| <= pi/4. The series of sine up to x^17: the next term is below 1e-19 of x.
Real sineNearZero(Real x, Real low) {
  if (low == 0 && std::abs(x) < kTiny) return x;
  const Real z = x * x;
  Real tail = 1.0 / 355687428096000;              // 1/17!
  tail = -1.0 / 1307674368000 + z * tail;         // -1/15!
  tail = 1.0 / 6227020800 + z * tail;             // 1/13!
  tail = -1.0 / 39916800 + z * tail;              // -1/11!
  tail = 1.0 / 362880 + z * tail;                 // 1/9!
  tail = -1.0 / 5040 + z * tail;                  // -1/7!
  tail = 1.0 / 120 + z * tail;                    // 1/5!
  tail = -1.0 / 6 + z * tail;                     // -1/3!
  return x + (x * z * tail + low * (1 - z / 2));  // the derivative of sine is cosine
}

// cos(x + low) for |x| <= pi/4. The series of cosine up to x^16: the next term is below 3e-18.
Real cosineNearZero(Real x, Real low) {
  const Real z = x * x;
  Real tail = 1.0 / 20922789888000;      // 1/16!
  tail = -1.0 / 87178291200 + z * tail;  // -1/14!
  tail = 1.0 / 479001600 + z * tail;     // 1/12!
  tail = -1.0 / 3628800 + z * tail;      // -1/10!
  tail = 1.0 / 40320 + z * tail;         // 1/8!
  tail = -1.0 / 720 + z * tail;          // -1/6!
  tail = 1.0 / 24 + z * tail;            // 1/4!
  // 1 - z/2 is rounded; what it lost is added with the small terms.
  const Real half = z / 2;
  const Real head = 1 - half;
  return head + (((1 - head) - half) + (z * z * tail - x * low));
}

SineCosine turnedBack(const QuarterTurns& turns) {
  const Real s = sineNearZero(turns.high, turns.low);
  const Real c = cosineNearZero(turns.high, turns.low);
  switch (turns.quarters) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

// An angle as a rounded part and what the rounding lost.
struct Angle {
  Real high = 0;
  Real low = 0;
};

// arctan(k/16), rounded, and what the rounding lost.
constexpr std::array<Real, 17> kArctangents = {
    0x0.0p+0,
    0x1.ff55bb72cfdeap-5,
    0x1.fd5ba9aac2f6ep-4,
    0x1.7b97b4bce5b02p-3,
    0x1.f5b75f92c80ddp-3,
    0x1.362773707ebccp-2,
    0x1.6f61941e4def1p-2,
    0x1.a64eec3cc23fdp-2,
    0x1.dac670561bb4fp-2,
    0x1.0657e94db30d0p-1,
    0x1.1e00babdefeb4p-1,
    0x1.345f01cce37bbp-1,
    0x1.4978fa3269ee1p-1,
    0x1.5d58987169b18p-1,
    0x1.700a7c5784634p-1,
    0x1.819d0b7158a4dp-1,
    0x1.921fb54442d18p-1,
};
constexpr std::array<Real, 17> kArctangentRests = {
    0x0.0p+0,
    -0x1.c934d86d23f1dp-60,
    -0x1.cd37686760c17p-59,
    0x1.347b0b4f881cap-58,
    0x1.8ab6e3cf7afbdp-57,
    -0x1.963a544b672d8p-57,
    -0x1.c63aae6f6e918p-56,
    -0x1.24dec1b50b7ffp-56,
    0x1.a2b7f222f65e2p-56,
    -0x1.d5b495f6349e6p-56,
    -0x1.928df287a668fp-58,
    0x1.1021137c71102p-55,
    0x1.2419a87f2a458p-56,
    0x1.0028e4bc5e7cap-57,
    -0x1.8c34d25aadef6p-56,
    -0x1.bf76229d3b917p-56,
    0x1.1a62633145c07p-55,
};

// (arctan t - t) / t for |t| <= 2.5/16: the series up to t^19; the next term is below 4e-18.
Real arctangentTail(Real t) {
  const Real z = t * t;
  Real tail = -1.0 / 19;
  tail = 1.0 / 17 + z * tail;
  tail = -1.0 / 15 + z * tail;
  tail = 1.0 / 13 + z * tail;
  tail = -1.0 / 11 + z * tail;
  tail = 1.0 / 9 + z * tail;
  tail = -1.0 / 7 + z * tail;
  tail = 1.0 / 5 + z * tail;
  tail = -1.0 / 3 + z * tail;
  return z * tail;
}

// arctan(small / large) for 0 <= small <= large, from arctan c + arctan((q - c) / (1 + q c)) with
// the nearest c = k/16.
Angle arctangentOfRatio(Real small, Real large) {
  if (small == 0) return {0, 0};
  if (std::isinf(large)) {
    if (!std::isinf(small)) return {0, 0};
    small = large = 1;
  }
  if (small < large * 0x1p-60) return {small / large, 0};

  // The quotient with the digits that its rounding lost, found from the exact remainder. Scaling by
  // a power of two keeps the products in range.
  int exponent = 0;
  large = std::frexp(large, &exponent);
  small = std::ldexp(small, -exponent);
  const Real q = small / large;
  const TwoProduct back = twoProduct(q, large);
  const Real lost = ((small - back.product) - back.error) / large / (1 + q * q);

  constexpr Real kSeriesAlone = 2.5 / 16;
  if (q < kSeriesAlone) return {q, q * arctangentTail(q) + lost};
  const int k = static_cast<int>(16 * q + 0.5);
  const Real c = k / 16.0;
  const Real t = (q - c) / (1 + q * c);  // q - c is exact
  return {kArctangents[k], t + (t * arctangentTail(t) + (kArctangentRests[k] + lost))};
}

// base + angle or base - angle, rounded once.
Real combine(Real base, Real baseRest, Angle angle) {
  const TwoSum s = twoSum(base, angle.high);
  return s.sum + (s.error + (baseRest + angle.low));
}

}  // namespace

Real sine(Real angle) {
  const QuarterTurns turns = quarterTurns(angle);
  const Real value = turns.quarters % 2 == 0 ? sineNearZero(turns.high, turns.low)
                                             : cosineNearZero(turns.high, turns.low);
  return turns.quarters < 2 ? value : -value;
}

Real cosine(Real angle) {
  const QuarterTurns turns = quarterTurns(angle);
  const Real value = turns.quarters % 2 == 0 ? cosineNearZero(turns.high, turns.low)
                                             : sineNearZero(turns.high, turns.low);
  return turns.quarters == 0 || turns.quarters == 3 ? value : -value;
}

SineCosine sineCosine(Real angle) {
  return turnedBack(quarterTurns(angle));
}

Real arctangent(Real tangent) {
  return arctangent2(tangent, 1);
}

Real arctangent2(Real y, Real x) {
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const bool left = std::signbit(x);
  const Real width = std::abs(x), height = std::abs(y);
  Real angle = 0;
  if (height <= width) {
    const Angle a = arctangentOfRatio(height, width);
    angle = left ? combine(kPi, kPiRest, {-a.high, -a.low}) : a.high + a.low;
  } else {
    const Angle a = arctangentOfRatio(width, height);
    angle =
        left ? combine(kHalfPi, kHalfPiRest, a) : combine(kHalfPi, kHalfPiRest, {-a.high, -a.low});
  }
  return std::copysign(angle, y);
}

}  // namespace carom
