#pragma once
// A number of twice the digits, as the sum of two doubles.
//
// Method: hi is the number rounded to double, lo what was lost. Sums and products return their
// rounding errors exactly (TwoSum, TwoProduct), and those are carried along in lo.
// Why: 106 bits from plain double operations, the same on every machine; long double has 64 bits on
// some machines and 53 on others.
// Source: Dekker 1971; Knuth, TAOCP 2, 4.2.2; Joldes, Muller and Popescu 2017 (error bounds).
// Not handled: overflow (numbers above 1e300), and digits below 1e-300.

#include "carom/core/real.hpp"

namespace carom {

/// hi + lo, with |lo| at most half a unit in the last place of hi. Relative errors of the
/// operations are below 1e-31.
/// \ingroup mass
struct DoubleDouble {
  Real hi = 0;  ///< the number rounded to double
  Real lo = 0;  ///< what rounding lost

  /// Zero.
  DoubleDouble() = default;
  /// A double, exactly.
  /// \param number any double
  DoubleDouble(Real number) : hi(number) {  // NOLINT: meant to convert
  }
  /// Two parts that are normalised already.
  /// \param high rounded number
  /// \param low its error
  DoubleDouble(Real high, Real low) : hi(high), lo(low) {}
  /// The number rounded to double.
  explicit operator Real() const {
    return hi;
  }
};

/// a + b without any loss.
/// \param a first term
/// \param b second term
/// \return sum and its rounding error
/// \ingroup mass
inline DoubleDouble exactSum(Real a, Real b) {
  const Real sum = a + b;
  const Real partOfB = sum - a;
  return {sum, (a - (sum - partOfB)) + (b - partOfB)};
}

/// a · b without any loss.
/// \param a first factor
/// \param b second factor
/// \return product and its rounding error
/// \ingroup mass
inline DoubleDouble exactProduct(Real a, Real b) {
  // Each factor is cut into halves of 26 bits, whose products are exact (Veltkamp's splitting).
  constexpr Real kSplit = 134217729;  // 2^27 + 1
  const Real ca = kSplit * a;
  const Real cb = kSplit * b;
  const Real aHigh = ca - (ca - a);
  const Real bHigh = cb - (cb - b);
  const Real aLow = a - aHigh;
  const Real bLow = b - bHigh;
  const Real product = a * b;
  return {product, ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
}

namespace detail {
// hi + lo normalised again; |hi| >= |lo| or hi == 0.
inline DoubleDouble renormalized(Real hi, Real lo) {
  const Real sum = hi + lo;
  return {sum, lo - (sum - hi)};
}
}  // namespace detail

/// Sum.
/// \param a first term
/// \param b second term
/// \return a + b
/// \ingroup mass
inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exactSum(a.hi, b.hi);
  const DoubleDouble low = exactSum(a.lo, b.lo);
  const DoubleDouble first = detail::renormalized(high.hi, high.lo + low.hi);
  return detail::renormalized(first.hi, first.lo + low.lo);
}

/// Negative.
/// \param a number
/// \return -a
/// \ingroup mass
inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.hi, -a.lo};
}

/// Difference.
/// \param a first term
/// \param b what is subtracted
/// \return a - b
/// \ingroup mass
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

/// Product.
/// \param a first factor
/// \param b second factor
/// \return a b
/// \ingroup mass
inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exactProduct(a.hi, b.hi);
  return detail::renormalized(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// Quotient.
/// \param a what is divided
/// \param b divisor, not zero
/// \return a / b
/// \ingroup mass
inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const Real first = a.hi / b.hi;
  const DoubleDouble rest = a - b * DoubleDouble(first);
  const Real second = rest.hi / b.hi;
  const DoubleDouble rest2 = rest - b * DoubleDouble(second);
  return exactSum(first, second) + DoubleDouble(rest2.hi / b.hi);
}

/// Adds in place.
/// \param a what is changed
/// \param b what is added
/// \return a
/// \ingroup mass
inline DoubleDouble& operator+=(DoubleDouble& a, const DoubleDouble& b) {
  return a = a + b;
}

}  // namespace carom
