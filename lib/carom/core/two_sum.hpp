#pragma once
// How much does a rounded sum or product lose, exactly?
//
// The rounding error of + and * is itself a double and can be computed with a few more operations:
// sums after Knuth (The Art of Computer Programming 2, theorem 4.2.2.B), products after Dekker
// (Numerische Mathematik 18, 1971) with Veltkamp's splitting of a factor into two halves whose
// products are exact. The processor's fused multiply-add would give the product's error in one
// operation, but not every machine has one. This is the foundation of all that Carom computes more
// exactly than a double: chapter 7 explains it, the functions of elementary.hpp already need it.
// What it does not handle: overflow, and products whose error would fall below the smallest double.

#include <cmath>

#include "carom/core/real.hpp"

namespace carom {

/// A rounded sum and its rounding error: a + b = sum + error exactly.
/// \ingroup core
struct TwoSum {
  Real sum = 0;    ///< a + b rounded
  Real error = 0;  ///< what the rounding lost; at most half an ulp of sum
};

/// A rounded product and its rounding error: a b = product + error exactly.
/// \ingroup core
struct TwoProduct {
  Real product = 0;  ///< a b rounded
  Real error = 0;    ///< what the rounding lost; at most half an ulp of product
};

/// The sum of two numbers, error-free, in any order of size. (Knuth)
/// \param a first term, any finite number
/// \param b second term, any finite number
/// \return sum and error with a + b = sum + error exactly, if the sum does not overflow
/// \ingroup core
constexpr TwoSum twoSum(Real a, Real b) {
  const Real sum = a + b;
  const Real partOfB = sum - a;
  const Real partOfA = sum - partOfB;
  return {sum, (a - partOfA) + (b - partOfB)};
}

/// The sum of two numbers of which the first is the larger, error-free, in half the operations.
/// \param a larger term: |a| >= |b|, or a = 0
/// \param b smaller term
/// \return sum and error with a + b = sum + error exactly, if the sum does not overflow
/// \ingroup core
constexpr TwoSum fastTwoSum(Real a, Real b) {
  const Real sum = a + b;
  return {sum, b - (sum - a)};
}

/// The product of two numbers, error-free. (Dekker, Veltkamp)
/// \param a first factor, |a| < 1e300
/// \param b second factor, |b| < 1e300
/// \return product and error with a b = product + error exactly, if |a b| is between 1e-290 and
///   1e300, or zero
/// \ingroup core
constexpr TwoProduct twoProduct(Real a, Real b) {
  // Times 2^27 + 1 and back: the upper half has 26 bits, and so has the rest, thanks to its sign.
  constexpr Real kSplitter = 134217729;
  const Real aBig = kSplitter * a, bBig = kSplitter * b;
  const Real aHigh = aBig - (aBig - a), bHigh = bBig - (bBig - b);
  const Real aLow = a - aHigh, bLow = b - bHigh;
  const Real product = a * b;
  return {product, ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow};
}

}  // namespace carom
