#pragma once
// Do two convex polyhedra overlap, and how little would part them?
//
// Method: separating axes: the normals of the faces of both, and the cross products of every edge
// of A with every edge of B; all corners are projected on each. Of a tetrahedron's 44 axes 36 are
// cross products, of an icosahedron's 940 it is 900: never "half", as the source has it.
// Cost: (FA + FB + EA EB)(VA + VB) dot products, eightfold when the number of corners doubles: this
// is the text-book version, and what the fast one (separateHulls()) is measured against.
// Parallel edges are left out and faces win ties, as with boxes.
// Source: section 5.3; Gottschalk, Lin and Manocha 1996.
// Not handled: the last digits next to touching.

#include "carom/core/real.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separating_axis.hpp"

namespace carom {

/// The axis on which two convex polyhedra are farthest apart, or overlap least.
/// \param a first hull
/// \param A its pose
/// \param b second hull
/// \param B its pose
/// \return verdict, signed gap, unit axis from A to B, and the faces or edges that it belongs to
/// \erratum{5.6}
/// \erratum{5.7}
/// \erratum{5.8}
/// \ingroup detection
SeparatingAxis satHulls(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B);

}  // namespace carom
