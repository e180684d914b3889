#pragma once
// How far apart, or how deep in each other, are two convex polygons?
//
// Method: the loop of GJK in the plane (gjk_loop.hpp, the same as in space). Where the polygons
// overlap or touch: the edge normal with the least overlap (separatePolygons(), exact verdict), and
// on it a corner of one against the edge of the other.
// Source: Gilbert, Johnson and Keerthi 1988; the separating axes of the source's section 5.2.
// Not handled: concave polygons (a PlanarCompound of convex ones).

#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/separation.hpp"

namespace carom {

/// The signed distance of two convex polygons.
/// \param a polygon of A \param A its pose
/// \param b polygon of B \param B its pose
/// \return separation, unit normal from A to B, a point on each, and a status
/// \ingroup detection
PlanarSeparation planarGjk(const Polygon& a, const PlanarPose& A, const Polygon& b,
                           const PlanarPose& B);

}  // namespace carom
