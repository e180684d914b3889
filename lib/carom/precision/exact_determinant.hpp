#pragma once
// On which side of a plane is a point, without any doubt?
//
// The sign of det(a - o, b - o, c - o). A double's sign is trusted where it exceeds the largest
// error that it can have (the filter of Shewchuk's orient3d, Discrete & Computational Geometry 18,
// 1997), which is nearly always; then that of a double-double, which settles all but points in the
// plane. For these the determinant is multiplied out into 24 products of three coordinates, each of
// which is exactly the sum of four doubles, and those are added without error.

#include "carom/core/real.hpp"

namespace carom {

/// The sign of six times the volume of a tetrahedron, exactly: 1 if a, b, c run counter-clockwise
/// seen from outside, o being inside; -1 if clockwise; 0 if the four corners lie in one plane.
/// \param o first corner [m]
/// \param a second corner [m]
/// \param b third corner [m]
/// \param c fourth corner [m]
/// \return -1, 0 or 1
/// \throws InvalidInput if a coordinate is not finite, or if a coordinate other than 0 is more than
///   2^600 times smaller than the largest
/// \ingroup precision
int orientation(const Vector3& o, const Vector3& a, const Vector3& b, const Vector3& c);

/// det(a - o, b - o, c - o) of the coordinates as they are, rounded only once, at the end.
/// \param o first corner [m]
/// \param a second corner [m]
/// \param b third corner [m]
/// \param c fourth corner [m]
/// \return six times the signed volume [m^3], the double nearest to the exact value
/// \throws InvalidInput as orientation()
/// \ingroup precision
Real exactTetrahedronDeterminant(const Vector3& o, const Vector3& a, const Vector3& b,
                                 const Vector3& c);

/// det(a, b, c), rounded only once, at the end.
/// \param a first vector [any unit]
/// \param b second vector [any unit, same frame]
/// \param c third vector [any unit, same frame]
/// \return a . (b x c), the double nearest to the exact value
/// \throws InvalidInput as orientation()
/// \ingroup precision
Real exactDeterminant(const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace carom
