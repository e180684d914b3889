#pragma once
// On which side of a line is a point, whatever it takes?
//
// Twice the area of a triangle is ax by - ay bx + bx cy - by cx + cx ay - cy ax: six products, each
// exactly the sum of two doubles (twoProduct), and twelve doubles that are added without error
// (ExactSum). Where the differences of the corners need no rounding, as on a grid, two products are
// enough. This is the way out of orient2dFiltered(), a hundred times slower than the plain formula.

#include "carom/core/real.hpp"

namespace carom {

/// The sign of the area of a triangle, exactly: 1 if a, b, c run counter-clockwise, -1 if
/// clockwise, 0 if they are in a line.
/// \param a first corner [m] \param b second corner [m] \param c third corner [m]
/// \return -1, 0 or 1
/// \throws InvalidInput if a coordinate is not finite, or if a coordinate other than 0 is more than
///   2^900 times smaller than the largest
/// \ingroup precision
int exactOrient2d(const Vector2& a, const Vector2& b, const Vector2& c);

}  // namespace carom
