#pragma once
// Of which bits is a number made?
//
// A float has one bit for the sign, 8 for a power of two and 23 for a fraction; a double has 1, 11
// and 52. The stored power e and fraction f stand for 1.f * 2^(e - bias). That the first digit is
// always 1 saves a bit, but not every number is normalised so: below the smallest normal number the
// stored power is 0, the first digit is 0, and numbers thin out evenly down to zero. These are the
// subnormal numbers (IEEE 754-2019, 3.4). One template serves both sizes.

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "carom/core/real.hpp"

namespace carom {

/// What kind of number some bits are. \ingroup precision
enum class NumberKind {
  zero,        ///< power and fraction are 0
  subnormal,   ///< stored power 0: 0.f times the smallest power
  normal,      ///< 1.f times a power of two
  infinite,    ///< stored power all ones, fraction 0
  notANumber,  ///< stored power all ones, fraction not 0
};

/// A number taken apart. \ingroup precision
struct FloatBits {
  bool negative = false;               ///< the sign bit
  int storedPower = 0;                 ///< as stored: 0 to 255, or 0 to 2047
  std::uint64_t fraction = 0;          ///< the stored fraction, as a whole number
  int powerBits = 0;                   ///< length of the stored power: 8 or 11
  int fractionBits = 0;                ///< length of the fraction: 23 or 52
  int exponent = 0;                    ///< the number is 1.f (or 0.f) times two to this
  NumberKind kind = NumberKind::zero;  ///< what the bits stand for
};

/// Takes a number apart. The source says that a number is always normalised; subnormal ones are
/// not.
/// \erratum{8.1}
/// \tparam Number float or double
/// \param value any number, also infinite or NaN
/// \return its bits
/// \ingroup precision
template <class Number>
FloatBits bitsOf(Number value) {
  static_assert(std::is_same_v<Number, float> || std::is_same_v<Number, double>);
  using Limits = std::numeric_limits<Number>;
  using Integer = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
  constexpr int kFractionBits = Limits::digits - 1;  // the first digit is not stored
  constexpr int kPowerBits = 8 * static_cast<int>(sizeof(Number)) - 1 - kFractionBits;
  constexpr int kAllOnes = (1 << kPowerBits) - 1;

  const std::uint64_t bits = std::bit_cast<Integer>(value);
  FloatBits b;
  b.negative = (bits >> (kFractionBits + kPowerBits)) != 0;
  b.storedPower = static_cast<int>(bits >> kFractionBits) & kAllOnes;
  b.fraction = bits & ((std::uint64_t{1} << kFractionBits) - 1);
  b.powerBits = kPowerBits;
  b.fractionBits = kFractionBits;
  if (b.storedPower == kAllOnes) {
    b.kind = b.fraction == 0 ? NumberKind::infinite : NumberKind::notANumber;
  } else if (b.storedPower == 0) {
    b.kind = b.fraction == 0 ? NumberKind::zero : NumberKind::subnormal;
    b.exponent = Limits::min_exponent - 1;  // of the smallest normal number
  } else {
    b.kind = NumberKind::normal;
    b.exponent = b.storedPower - (Limits::max_exponent - 1);
  }
  return b;
}

/// The number that the bits stand for, put together again.
/// \param bits of a float or a double \return the number; a NaN for every kind of NaN
/// \ingroup precision
Real valueOf(const FloatBits& bits);

/// Bits as text, sign, power and fraction apart: "0 01111111 00000000000000000000000" is 1.
/// \param bits of a float or a double \return zeros and ones
/// \ingroup precision
std::string bitText(const FloatBits& bits);

/// The kind as a word. \param kind of number \return for example "subnormal" \ingroup precision
const char* kindName(NumberKind kind);

}  // namespace carom
