#pragma once
// Do two boxes overlap, and how little would part them?
//
// Method: fifteen separating axes: three normals of A, three of B, and the nine cross products of
// an edge direction of A with one of B. The shadow of a box is its centre's, as wide as the sum of
// its half extents times |cosines|.
// Why the cross products: two boxes can pass each other edge by edge, and then no face shows the
// gap. The source takes the edges themselves as axes; those of a box are its face normals again,
// so its recipe adds nothing.
// Parallel edges: their cross product has no direction, only rounding, and is left out; the normals
// of the faces beside them are then enough. Faces win ties (kAxisTie).
// Source: Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH 1996.
// Not handled: the last digits next to touching and next to parallel edges; separateBoxes() knows
// more.

#include "carom/core/real.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The axis on which two boxes are farthest apart, or overlap least.
/// \param a first box
/// \param A its pose
/// \param b second box
/// \param B its pose
/// \return verdict, signed gap, unit axis from A to B; features are numbers of box axes, 0 to 2
/// \erratum{5.6}
/// \erratum{5.16}
/// \erratum{5.17}
/// \ingroup detection
SeparatingAxis satBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B);

}  // namespace carom
