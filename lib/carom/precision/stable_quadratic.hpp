#pragma once
// Where is a parabola zero?
//
// (-b + sqrt(b^2 - 4 a c)) / 2a is right on paper. In numbers it cancels twice: inside the root if
// the roots are nearly equal, and before it if one root is much smaller than the other. The first
// is cured by computing b^2 - 4 a c as if with twice the digits (difference_of_products.hpp), the
// second by computing only the root of larger size from the formula, where two numbers of one sign
// are added, and the other from the product of the roots, c / a (Higham, Accuracy and Stability of
// Numerical Algorithms, 2002, 1.8). Times of impact are roots of such equations. What it does not
// handle: roots beyond the largest double, which come out infinite.

#include "carom/core/real.hpp"

namespace carom {

/// How many numbers solve an equation. \ingroup precision
enum class RootCount {
  none,  ///< no real number does
  one,   ///< one does: the equation is linear, or its two roots are equal
  two,   ///< two different ones do
  all,   ///< every number does: all coefficients are 0
};

/// The real roots of a quadratic equation. \ingroup precision
struct QuadraticRoots {
  RootCount count = RootCount::none;  ///< how many there are
  Real first = 0;                     ///< the smaller one, or the only one; 0 if none or all
  Real second = 0;                    ///< the larger one, or the only one; 0 if none or all
};

/// Solves a x^2 + b x + c = 0. Whether there are none, one or two roots is decided exactly.
/// \param a coefficient of x^2, may be 0
/// \param b coefficient of x, may be 0
/// \param c constant term, may be 0
/// \return the roots in increasing order; error below 3 ulp of each
/// \throws InvalidInput if a coefficient is not finite
/// \ingroup precision
QuadraticRoots stableQuadratic(Real a, Real b, Real c);

}  // namespace carom
