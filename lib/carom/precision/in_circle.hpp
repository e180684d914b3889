#pragma once
// Is a point inside the circle through three others?
//
// The sign of a determinant of degree four in the differences of the points, filtered and exact in
// the same way as orient2d_filtered.hpp, with stage A of Shewchuk's incircle (Discrete &
// Computational Geometry 18, 1997). Where that is not enough, double-doubles settle all but points
// on the circle. Triangulations and the corners of a hull's caps are decided by
// it. What it does not handle: coordinates that differ in size by more than 2^440.

#include "carom/core/real.hpp"
#include "carom/precision/filtered_sign.hpp"

namespace carom {

/// The determinant whose sign inCircle() gives, rounded as it comes.
/// \tparam Number float or double
/// \param a first point of the circle [m] \param b second point [m] \param c third point [m]
/// \param d the point asked for [m]
/// \return positive inside the circle if a, b, c run counter-clockwise [m^4]
/// \ingroup precision
template <class Number>
Number inCircleDeterminant(const Eigen::Matrix<Number, 2, 1>& a,
                           const Eigen::Matrix<Number, 2, 1>& b,
                           const Eigen::Matrix<Number, 2, 1>& c,
                           const Eigen::Matrix<Number, 2, 1>& d) {
  const Number ax = a.x() - d.x(), ay = a.y() - d.y(), bx = b.x() - d.x(), by = b.y() - d.y(),
               cx = c.x() - d.x(), cy = c.y() - d.y();
  return (ax * ax + ay * ay) * (bx * cy - cx * by) + (bx * bx + by * by) * (cx * ay - ax * cy) +
         (cx * cx + cy * cy) * (ax * by - bx * ay);
}

/// Whether d is inside the circle through a, b and c: sign 1 inside, -1 outside, 0 on the circle,
/// if a, b, c run counter-clockwise; the other way round if clockwise; exact.
/// \param a first point of the circle [m]
/// \param b second point of the circle [m]
/// \param c third point of the circle [m]
/// \param d the point asked for [m]
/// \return the sign, and whether the filter was enough
/// \throws InvalidInput if a coordinate is not finite, or if a coordinate other than 0 is more than
///   2^440 times smaller than the largest
/// \ingroup precision
FilteredSign inCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d);

}  // namespace carom
