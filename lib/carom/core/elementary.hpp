#pragma once
// How does the simulation compute sine, cosine and arctangent to the same bits everywhere?
//
// The C libraries of Linux, macOS, Windows and WebAssembly round these functions differently in the
// last bit, and a collision turns one bit into another game. These versions use only + - * / and
// comparisons on IEEE doubles, never a fused multiply-add, so every compiler and machine agrees.
//
// Method: the angle is reduced to [-pi/4, pi/4] plus a number of quarter turns (quarter_turns.hpp),
// the ratio y/x to a point near k/16 with a known arctangent; there a Taylor series converges fast
// enough that its coefficients are the ones everybody knows, 1/n! and 1/(2n+1). A minimax
// polynomial would save two multiplications and hide where its numbers come from. Every rounding
// that matters is caught in a second double and added at the end, as in fdlibm (Ng, Sun
// Microsystems, 1993), whose way of adding the tail is followed. Functions round to nearest; other
// modes are not handled.

#include "carom/core/real.hpp"

namespace carom {

/// Sine and cosine of one angle.
/// \ingroup core
struct SineCosine {
  Real sine = 0;    ///< sine of the angle [1]
  Real cosine = 1;  ///< cosine of the angle [1]
};

/// Sine, the same bits on every machine; error below 1 ulp for every finite angle. Exact at 0,
/// whose sign it keeps; odd: sine(-x) == -sine(x) bit by bit.
/// \param angle [rad], any size
/// \return sine of the angle in [-1, 1]; not a number for an infinite angle or NaN
/// \ingroup core
Real sine(Real angle);

/// Cosine, the same bits on every machine; error below 1 ulp for every finite angle. Exact at 0;
/// even: cosine(-x) == cosine(x) bit by bit.
/// \param angle [rad], any size
/// \return cosine of the angle in [-1, 1]; not a number for an infinite angle or NaN
/// \ingroup core
Real cosine(Real angle);

/// Sine and cosine together: the same bits as sine() and cosine() for one reduction of the angle.
/// \param angle [rad], any size
/// \return both values; not a number for an infinite angle or NaN
/// \ingroup core
SineCosine sineCosine(Real angle);

/// Arctangent, the same bits on every machine; error below 1 ulp. Odd, keeps the sign of zero.
/// \param tangent [1], any value; infinity gives a quarter turn
/// \return the angle in [-pi/2, pi/2] whose tangent this is [rad]; NaN for NaN
/// \ingroup core
Real arctangent(Real tangent);

/// The angle of the point (x, y), the same bits on every machine; error below 1 ulp. Note the
/// order: y first, as everywhere. Zeros, their signs and infinities are treated as std::atan2 does.
/// \param y second coordinate [any unit]
/// \param x first coordinate [the same unit]
/// \return the angle from the x axis in [-pi, pi] [rad]; NaN if either is NaN
/// \ingroup core
Real arctangent2(Real y, Real x);

}  // namespace carom
