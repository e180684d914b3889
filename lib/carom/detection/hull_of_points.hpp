#pragma once
// Which convex solid is wrapped around a cloud of points?
//
// Method: incremental. The points are sorted along a slanted direction, so each new one lies
// outside the hull so far, and the faces that it sees begin at the point before it. They are
// removed and their rim is joined to the new point. "Sees" is decided by an exact sign
// (precision/exact_determinant.hpp), so no rounding can tear the surface, whatever the points:
// a rim edge borders a face that is truly seen, so the new triangles always have an area.
// Afterwards triangles that lie in one plane, to kFlatness, become one face.
// Why not a tolerance while building: nearly coplanar points then see contradictory sets of faces;
// most reports of broken hulls are about that. Here the tolerance comes after the topology.
// Source: the beneath-beyond method (Kallay 1981; Preparata and Shamos 1985, section 3.4.2) with
// Shewchuk's predicates (1997); half-edges and merged faces after Gregorius (GDC 2014).
// Not handled: simplifying a hull to fewer corners. Points nearer to each other, or to a face, than
// kFlatness times the largest coordinate count as the same, or as on it.

#include <span>

#include "carom/core/real.hpp"
#include "carom/detection/convex_hull.hpp"

namespace carom {

/// The convex hull of points.
/// \param points at least 4 that do not lie in one plane, in any order, also with duplicates
///   [m, body]
/// \return hull with flat faces merged and only corners kept, in the order of the points; no point
///   lies farther outside than 2 kFlatness times the largest coordinate
/// \throws InvalidInput if a coordinate is not finite, or the points coincide or lie in a line or a
///   plane (to kFlatness); the message says which
/// \ingroup detection
ConvexHull hullOfPoints(std::span<const Vector3> points);

}  // namespace carom
