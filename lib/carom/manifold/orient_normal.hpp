#pragma once
// Which of the two directions of an axis points from A to B?
//
// Method: the direction in which B comes free sooner. Push B forwards along the axis until its near
// end passes A's far end, or backwards until its far end passes A's near end, and compare.
// Why not the line from centre to centre, as the source suggests: the centres only agree with it
// for bodies whose shadows lie evenly around them. A nail has its centre near the head: driven
// through a board, it comes out forwards or backwards by its ends, not by its centre.
// Why not the sign that the axis happens to have: a cross product of edges points either way.
// Source: section 5.4, put right.
// Not handled: when both ways are equally long the axis keeps its own direction.

#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// An axis, reversed if need be, so that it points from A to B.
/// \param axis direction, not zero; need not be of length one [any unit, world]
/// \param a corners of A, at least one [m, world]
/// \param b corners of B, at least one [m, world]
/// \return axis or -axis: the one along which B has the shorter way out of A
/// \throws InvalidInput if a body has no corners
/// \ingroup manifold
Vector3 orientNormal(const Vector3& axis, std::span<const Vector3> a, std::span<const Vector3> b);

}  // namespace carom
