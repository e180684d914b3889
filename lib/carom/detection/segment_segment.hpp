#pragma once
// Which points of two segments are nearest to each other?
//
// Method: the nearest points are either both inside, where the gap is square to both, or one of
// them is an end; so the four ends are tried, and the inside solution if it lies inside. The
// nearest pair wins.
// Why so plainly: the usual chain of clamps divides by the squared sine of the angle between them
// and goes wrong for nearly parallel ones. Here that solution is only one candidate of five.
// Source: Lumelsky 1985; Ericson 2005, section 5.1.9.
// Not handled: which of the many nearest pairs of parallel segments is reported; the first.

#include "carom/core/real.hpp"

namespace carom {

/// The nearest points of two segments. \ingroup detection
struct SegmentPair {
  Vector3 pointA = Vector3::Zero();  ///< on the first [m]
  Vector3 pointB = Vector3::Zero();  ///< on the second [m]
  Real squared = 0;                  ///< squared distance between them [m^2]
  bool insideA = false;              ///< pointA is not an end
  bool insideB = false;              ///< pointB is not an end
};

/// The nearest points of two segments.
/// \param a0 one end of the first [m] \param a1 its other end; may be the same [m]
/// \param b0 one end of the second [m, the same frame] \param b1 its other end; may be the same [m]
/// \return the nearest points
/// \ingroup detection
SegmentPair closestPoints(const Vector3& a0, const Vector3& a1, const Vector3& b0,
                          const Vector3& b1);

/// The point of a segment nearest to a point.
/// \param point any point [m] \param a one end [m] \param b the other end; may be the same [m]
/// \return the nearest point of the segment [m]
/// \ingroup detection
Vector3 closestOnSegment(const Vector3& point, const Vector3& a, const Vector3& b);

/// The point of a triangle nearest to a point.
/// \param point any point [m] \param a first corner [m] \param b second corner [m]
/// \param c third corner [m] \return the nearest point of the triangle [m]
/// \ingroup detection
Vector3 closestOnTriangle(const Vector3& point, const Vector3& a, const Vector3& b,
                          const Vector3& c);

}  // namespace carom
