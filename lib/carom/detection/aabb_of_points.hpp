#pragma once
// Which box with sides along the axes holds a cloud of points?
//
// Method: start with the first point and widen the box by each other one.
// Why the first point: a box that starts at zero would always hold the origin, also when the
// points do not.
// Source: section 5.3.1 of the source.
// Not handled: the box of a moving body over a step (chapter 8 fattens it).

#include <span>

#include "carom/core/real.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// The smallest axis-aligned box around points.
/// \param points at least one [m, world]
/// \return the box; every point is inside or on its surface, every side holds a point
/// \throws InvalidInput if there are no points or a coordinate is not finite
/// \ingroup detection
Aabb<3> aabbOfPoints(std::span<const Vector3> points);

}  // namespace carom
