#pragma once
// Where is a body, seen from an origin that is far out with it?
//
// Bodies that meet are near each other, wherever they are, so everything that a collision needs is
// a small difference of two large positions. If the difference of the cells is taken first, in
// whole numbers, nothing is lost: only then is the result turned into metres. Adding up cell and
// offset first and subtracting afterwards loses what the cells were for.

#include "carom/core/real.hpp"
#include "carom/precision/cell_position.hpp"

namespace carom {

/// A position relative to an origin.
/// \param position of the body
/// \param origin a body, a camera, or the middle of a cell
/// \return position - origin [m, world axes]; error below 2 ulp of the larger of the result and a
///   cell: 1e-12 m for bodies in neighbouring cells
/// \ingroup precision
Vector3 relativeToOrigin(const CellPosition& position, const CellPosition& origin);

}  // namespace carom
