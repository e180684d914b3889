#pragma once
// What is left of a polygon behind a plane?
//
// Method: Sutherland and Hodgman: walk once around the polygon; keep the corners behind the plane,
// and where an edge crosses it put a corner. Clipping by the side planes of a face, one after the
// other, leaves what lies above that face.
// Why it closes: the edge from the last corner back to the first is an edge like any other; a walk
// that forgets it leaves a corner outside.
// A corner on the plane is behind it and makes no second corner, and a crossing is computed from
// the corner behind towards the one in front, so an edge gives the same point whichever way it is
// walked: nothing is doubled, and no tolerance is needed.
// Source: Sutherland and Hodgman, CACM 17, 1974; the source's reference [20].
// Not handled: concave polygons may come out with edges on top of each other.

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// The part of a flat convex polygon with normal . x <= offset.
/// \param polygon corners in order, either way round; may be empty, one point, or a line [m]
/// \param normal of the plane, not zero; need not be of length one [any unit, same frame]
/// \param offset normal . x on the plane [unit of normal times m]
/// \return corners in the same order; empty if all is in front
/// \ingroup manifold
std::vector<Vector3> clipPolygon(std::span<const Vector3> polygon, const Vector3& normal,
                                 Real offset);

}  // namespace carom
