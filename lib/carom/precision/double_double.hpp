#pragma once
// A number with twice the digits of a double.
//
// An unevaluated sum high + low of two doubles that do not overlap: 106 bits, 32 decimal digits, at
// ten to twenty times the cost of a double. Volumes of slivers cancel nearly all digits of a
// double; here 16 are left. Sum and product after Dekker 1971 in the accurate form, with the error
// bounds of Joldes, Muller and Popescu (ACM TOMS 44(2), 2017). It has the range of a double, not
// more: overflow and products below 1e-290 are not handled.

#include "carom/core/two_sum.hpp"

namespace carom {

/// high + low, with |low| at most half an ulp of high.
/// \ingroup precision
struct DoubleDouble {
  Real high = 0;  ///< the number rounded to a double
  Real low = 0;   ///< what that rounding lost

  /// Zero.
  constexpr DoubleDouble() = default;
  /// A double, exactly. Implicit, so that formulas mix both. \param value any number
  constexpr DoubleDouble(Real value) : high(value) {}
  /// Two parts that do not overlap. \param h rounded number \param l what rounding lost
  constexpr DoubleDouble(Real h, Real l) : high(h), low(l) {}

  /// The number as a double. \return high, which is the number rounded
  constexpr Real value() const {
    return high;
  }
};

/// The difference of two doubles, exactly. \param a first \param b second \return a - b
/// \ingroup precision
constexpr DoubleDouble exactDifference(Real a, Real b) {
  const TwoSum s = twoSum(a, -b);
  return {s.sum, s.error};
}

/// The product of two doubles, exactly. \param a first factor \param b second factor \return a b
/// \ingroup precision
constexpr DoubleDouble exactProduct(Real a, Real b) {
  const TwoProduct p = twoProduct(a, b);
  return {p.product, p.error};
}

/// The same number with the other sign. \param a any number \return -a \ingroup precision
constexpr DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

/// Sum, relative error below 3 * 2^-106, also when terms cancel.
/// \param a first term \param b second term \return a + b \ingroup precision
constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const TwoSum highs = twoSum(a.high, b.high);
  const TwoSum lows = twoSum(a.low, b.low);
  const TwoSum first = fastTwoSum(highs.sum, highs.error + lows.sum);
  const TwoSum second = fastTwoSum(first.sum, lows.error + first.error);
  return {second.sum, second.error};
}

/// Difference, relative error below 3 * 2^-106, also when terms cancel.
/// \param a first term \param b second term \return a - b \ingroup precision
constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + (-b);
}

/// Product, relative error below 7 * 2^-106.
/// \param a first factor \param b second factor \return a b \ingroup precision
constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const TwoProduct highs = twoProduct(a.high, b.high);
  const TwoSum s = fastTwoSum(highs.product, highs.error + (a.high * b.low + a.low * b.high));
  return {s.sum, s.error};
}

/// Quotient, relative error below 16 * 2^-106.
/// \param a dividend \param b divisor, not zero \return a / b \ingroup precision
constexpr DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const Real first = a.high / b.high;
  const DoubleDouble rest = a - b * first;
  const TwoSum s = fastTwoSum(first, rest.high / b.high);
  return {s.sum, s.error};
}

/// Adds in place. \param a is changed \param b second term \return a + b \ingroup precision
constexpr DoubleDouble& operator+=(DoubleDouble& a, const DoubleDouble& b) {
  return a = a + b;
}

}  // namespace carom
