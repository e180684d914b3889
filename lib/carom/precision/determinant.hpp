#pragma once
// The determinant of three vectors, with digits to spare.
//
// det(a, b, c) = a . (b x c) is the signed volume of the box that the vectors span, six times that
// of the tetrahedron. For a flat tetrahedron its terms cancel, and a double keeps no digit at all.
// In double-double arithmetic the differences of the corners and the products are exact and only
// the last sums round, at 2^-104 of the largest term. For the sign beyond any doubt:
// exact_determinant.hpp.

#include "carom/core/real.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {

/// The determinant of the matrix with columns a, b, c.
/// \param a first vector [any unit]
/// \param b second vector [any unit, same frame]
/// \param c third vector [any unit, same frame]
/// \return a . (b x c); error below 2^-101 times |a||b||c|, not rounded to a double yet
/// \ingroup precision
DoubleDouble determinant(const Vector3& a, const Vector3& b, const Vector3& c);

/// Six times the signed volume of a tetrahedron: det(a - o, b - o, c - o), the differences taken
/// without rounding. Positive if a, b, c run counter-clockwise seen from outside, o being inside.
/// \param o first corner, the common origin [m]
/// \param a second corner [m]
/// \param b third corner [m]
/// \param c fourth corner [m]
/// \return the determinant [m^3]; error below 2^-99 times the product of the three edge lengths
/// \ingroup precision
DoubleDouble tetrahedronDeterminant(const Vector3& o, const Vector3& a, const Vector3& b,
                                    const Vector3& c);

}  // namespace carom
