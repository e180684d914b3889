#pragma once
// Do two convex polygons overlap, and how little would part them?
//
// Method: separating axes. If a line fits between them, then one fits that is parallel to an edge
// of one of them; so project both on the normal of every edge of A and of B and keep the largest
// gap.
// Why both: the source walks along the edges of A only, and calls 903 of 20000 random pairs
// colliding that are not. Why normals: an edge's own direction shows the length of the edge, not
// what lies beyond it. Touching means that no axis separates and that one just touches; the source
// wants all axes to touch, as only two corners whose sides are in line do.
// Cost: (nA + nB)² dot products. Source: section 5.2; Gottschalk, Lin and Manocha 1996.
// Not handled: concave polygons; they are cut into convex parts.

#include <span>

#include "carom/core/real.hpp"
#include "carom/detection/separating_axis.hpp"

namespace carom {

/// The axis on which two convex polygons are farthest apart, or overlap least.
/// \param a corners of A, counter-clockwise, at least 3, no two neighbours equal [m, world]
/// \param b corners of B, likewise [m, world]
/// \return verdict, signed gap, unit axis from A to B with z = 0, and the edge it belongs to (the
///   edge from corner i to corner i + 1 has number i); of equal gaps the first counts, A's edges
///   before B's
/// \throws InvalidInput if a polygon has fewer than 3 corners
/// \erratum{5.3}
/// \erratum{5.4}
/// \ingroup detection
SeparatingAxis satPolygons(std::span<const Vector2> a, std::span<const Vector2> b);

}  // namespace carom
