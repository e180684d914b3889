#pragma once
// Which point of a body lies farthest in a direction?
//
// Method: the largest inner product with the direction. The first of several equal ones, so that
// the answer does not depend on the machine.
// Why: it is all that GJK wants to know of a shape, and the end of its shadow on an axis.
// Source: Gilbert, Johnson and Keerthi 1988; the source text names GJK in 5.2.
// Not handled: hulls of hundreds of points, for which walking along the edges is faster
// (support.hpp).

#include <cstddef>
#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// The number of the point that lies farthest in a direction.
/// \param points at least one [m, any frame]
/// \param direction any length [any unit, the same frame]; zero makes all points equal
/// \return index of the farthest point, the smallest one of several
/// \throws InvalidInput if there are no points
/// \ingroup detection
std::size_t supportPoint(std::span<const Vector3> points, const Vector3& direction);

}  // namespace carom
