#pragma once
// On which side of a line is a point, without any doubt and nearly at the price of the formula?
//
// A rounded value is wrong by no more than its error bound. If it is farther from zero than that,
// its sign is right, and that is so for all but one in thousands of random points. Only the rest is
// handed to exact numbers (exact_orient2d.hpp). The bound is that of stage A of Shewchuk's orient2d
// (Discrete & Computational Geometry 18, 1997): it grows with the products, not with a fixed
// epsilon, so it is right for grains and for planets.

#include "carom/core/real.hpp"
#include "carom/precision/filtered_sign.hpp"

namespace carom {

/// On which side of the line from a to b is c: sign 1 to the left (a, b, c run counter-clockwise),
/// -1 to the right, 0 on the line; exact for all coordinates.
/// \param a first point of the line [m]
/// \param b second point of the line [m]; if it is a, the answer is 0
/// \param c the point asked for [m]
/// \return the sign, and whether the filter was enough
/// \throws InvalidInput as exactOrient2d()
/// \ingroup precision
FilteredSign orient2dFiltered(const Vector2& a, const Vector2& b, const Vector2& c);

}  // namespace carom
