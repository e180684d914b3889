#pragma once
// What does a set of points cover on an axis?
//
// Method: the coordinate of a point along an axis is its dot product with the unit vector of the
// axis; the smallest and the largest coordinate are the ends of its shadow. Vertices suffice: the
// shadow of an edge or a face ends at the shadows of its corners, so nothing is gained by
// projecting edges, as the source asks.
// Why the axis is normalised here: a dot product with a vector of length 3 is three times too long.
// That does not change whether two shadows overlap, but depths on different axes are compared, and
// then the longer axis looks deeper.
// Not handled: round bodies; their shadow is that of their centre, widened by the radius.

#include <span>

#include "carom/core/real.hpp"
#include "carom/detection/interval.hpp"

namespace carom {

/// The interval that points cover on the line through the origin along an axis.
/// \param points at least one point [m]
/// \param axis direction, any length but zero [any unit, same frame]
/// \return smallest and largest coordinate along the axis [m]
/// \throws InvalidInput if there are no points, or the axis is zero or not finite
/// \erratum{5.7}
/// \ingroup detection
Interval project(std::span<const Vector3> points, const Vector3& axis);

}  // namespace carom
