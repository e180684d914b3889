#pragma once
// Four numbers with twice the digits of a double, side by side.
//
// The same sums and products as those of DoubleDouble, whose header says where they are from, on
// four numbers at once: lane by lane they give the same bits. They have few dependencies and no
// branches, so four cost little more than one. This header is for the library.
// Not handled: quotients; overflow, and products below 1e-290.

#include "carom/mass/four_lanes.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {

/// Four numbers high + low. \ingroup mass
struct FourDoubleDoubles {
  Four high{};  ///< the numbers rounded to doubles
  Four low{};   ///< what that rounding lost

  /// One of the four. \param lane 0 to 3 \return the number
  DoubleDouble lane(std::size_t lane) const {
    return {high[lane], low[lane]};
  }
};

/// a + b exactly, for any a and b (Knuth). \param a terms \param b terms \return sums and errors
/// \ingroup mass
CAROM_INLINE FourDoubleDoubles twoSums(const Four& a, const Four& b) {
  const Four sum = a + b;
  const Four partOfB = sum - a;
  return {sum, (a - (sum - partOfB)) + (b - partOfB)};
}

/// a + b exactly, for |a| >= |b| (Dekker). \param a terms \param b terms \return sums and errors
/// \ingroup mass
CAROM_INLINE FourDoubleDoubles fastTwoSums(const Four& a, const Four& b) {
  const Four sum = a + b;
  return {sum, b - (sum - a)};
}

/// a b exactly (Dekker, Veltkamp). \param a factors \param b factors \return products and errors
/// \ingroup mass
CAROM_INLINE FourDoubleDoubles twoProducts(const Four& a, const Four& b) {
  constexpr Real kSplitter = 134217729;  // 2^27 + 1
  const Four aBig = kSplitter * a, bBig = kSplitter * b;
  const Four aHigh = aBig - (aBig - a), bHigh = bBig - (bBig - b);
  const Four aLow = a - aHigh, bLow = b - bHigh;
  const Four product = a * b;
  return {product, ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
}

/// Sums. \param a terms \param b terms \return a + b \ingroup mass
CAROM_INLINE FourDoubleDoubles operator+(const FourDoubleDoubles& a, const FourDoubleDoubles& b) {
  const FourDoubleDoubles highs = twoSums(a.high, b.high);
  const FourDoubleDoubles lows = twoSums(a.low, b.low);
  const FourDoubleDoubles first = fastTwoSums(highs.high, highs.low + lows.high);
  return fastTwoSums(first.high, lows.low + first.low);
}

/// Differences. \param a terms \param b what is taken away \return a - b \ingroup mass
CAROM_INLINE FourDoubleDoubles operator-(const FourDoubleDoubles& a, const FourDoubleDoubles& b) {
  return a + FourDoubleDoubles{-b.high, -b.low};
}

/// Products. \param a factors \param b factors \return a b \ingroup mass
CAROM_INLINE FourDoubleDoubles operator*(const FourDoubleDoubles& a, const FourDoubleDoubles& b) {
  const FourDoubleDoubles highs = twoProducts(a.high, b.high);
  return fastTwoSums(highs.high, highs.low + (a.high * b.low + a.low * b.high));
}

/// Adds in place. \param a is changed \param b terms \return a + b \ingroup mass
CAROM_INLINE FourDoubleDoubles& operator+=(FourDoubleDoubles& a, const FourDoubleDoubles& b) {
  return a = a + b;
}

}  // namespace carom
