#pragma once
// On which side of a line is a point, as a plain formula says?
//
// Twice the area of the triangle a, b, c: positive to the left of the line from a to b, negative to
// the right. Rounded, it may have the wrong sign or be 0 where it is not: near the line its verdict
// is a pattern of chance (Kettner, Mehlhorn, Pion, Schirra and Yap, Computational Geometry 40,
// 2008, draw it). orient2d_filtered.hpp is the version to build on; this one is here to be seen
// failing, and for its speed to be measured.

#include <Eigen/Core>

namespace carom {

/// Twice the signed area of a triangle, rounded as it comes.
/// \tparam Number float or double
/// \param a first corner [m] \param b second corner [m] \param c third corner [m]
/// \return positive if a, b, c run counter-clockwise [m^2]; error up to 4 ulp of the products
/// \ingroup precision
template <class Number>
Number orient2d(const Eigen::Matrix<Number, 2, 1>& a, const Eigen::Matrix<Number, 2, 1>& b,
                const Eigen::Matrix<Number, 2, 1>& c) {
  return (a.x() - c.x()) * (b.y() - c.y()) - (a.y() - c.y()) * (b.x() - c.x());
}

}  // namespace carom
