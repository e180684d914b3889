#pragma once
// How many quarter turns are in an angle, and what is left over?
//
// Subtracting k pi/2 cancels nearly all digits when the angle is close to a multiple, so pi/2 must
// be known to many more digits than a double holds. Up to a million quarter turns it is split into
// three parts of 33 bits, whose products with k are exact, and a tail (Cody and Waite 1980). Beyond
// that the bits of 2/pi that matter are multiplied exactly in integers (Payne and Hanek 1983): bits
// whose product with the angle is a multiple of four quarter turns are never looked at, so 192 bits
// do for every double.

#include "carom/core/real.hpp"

namespace carom {

/// An angle as quarter turns and a small rest: angle = (quarters + 4 n) pi/2 + high + low.
/// \ingroup core
struct QuarterTurns {
  int quarters = 0;  ///< number of quarter turns modulo 4, in 0..3
  Real high = 0;     ///< rest in [-pi/4, pi/4], rounded to a double [rad]
  Real low = 0;      ///< what that rounding lost [rad]
};

/// Reduces an angle to the nearest quarter turn. The rest high + low is right to 2^-69 of itself or
/// better, for every finite angle; just at an eighth turn it may pass pi/4 by a rounding error.
/// \param angle [rad]; must be finite, or the rest is not a number
/// \return quarter turns and rest
/// \ingroup core
QuarterTurns quarterTurns(Real angle);

}  // namespace carom
