#pragma once
// How are squares of coefficients kept from leaving the range of the doubles?
//
// Multiplying an equation by a power of two does not change its roots, and writing x = 2^k y
// multiplies them by one. Powers of two cost no digit. With k chosen so that the first and the last
// coefficient become equally large, b^2 and 4 a c can neither overflow nor lose digits that count.

#include "carom/core/real.hpp"

namespace carom {

/// a y^2 + b y + c = 0, whose roots times 2^exponent are those of the equation it was made from.
/// \ingroup precision
struct ScaledQuadratic {
  Real a = 0;        ///< coefficient of y^2, at most 1
  Real b = 0;        ///< coefficient of y, at most 1
  Real c = 0;        ///< constant term, at most 1
  int exponent = 0;  ///< x = y * 2^exponent
};

/// The same equation with coefficients that can be squared.
/// \param a coefficient of x^2 [any unit], finite
/// \param b coefficient of x, finite
/// \param c constant term, finite
/// \return the scaled equation; coefficients that are 0 stay so
/// \ingroup precision
ScaledQuadratic scaledQuadratic(Real a, Real b, Real c);

}  // namespace carom
