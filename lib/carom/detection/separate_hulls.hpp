#pragma once
// Do two polyhedra overlap? Fast, and right to the last digit.
//
// Method: the axes of satHulls(), of which hull_axes.hpp proves most to be needless. If the best
// gap is within its own rounding error of zero, all axes that could decide are computed again with
// exact numbers, on the corners that the poses make of the hulls; so touching bodies are called
// touching. There a face is the plane through its first three corners: one whose corners are not
// exactly in one plane has no other.
// The answer does not depend on the order of the arguments.
// Source: Gregorius, GDC 2013; Shewchuk 1997.
// Not handled: the distance of bodies whose nearest features are corners; that needs GJK.

#include "carom/core/real.hpp"
#include "carom/detection/convex_hull.hpp"
#include "carom/detection/hull_axes.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The axis on which two polyhedra are farthest apart, or overlap least: as satHulls(), with an
/// exact verdict.
/// \param a first hull
/// \param A its pose
/// \param b second hull
/// \param B its pose
/// \return verdict, signed gap, unit axis from A to B, and the faces or edges that it belongs to.
///   Swapping the arguments swaps the features and turns the axis, and changes nothing else.
/// \ingroup detection
SeparatingAxis separateHulls(const ConvexHull& a, const Pose& A, const ConvexHull& b,
                             const Pose& B);

/// The same for a box and a hull; the features of the box are those of boxHull().
/// \param a box
/// \param A its pose
/// \param b hull
/// \param B its pose
/// \return as separateHulls()
/// \ingroup detection
SeparatingAxis separateBoxAndHull(const Box& a, const Pose& A, const ConvexHull& b, const Pose& B);

namespace detail {

/// Whether a pair of polyhedra is to be treated as (b, a), by poses first, then by corners.
/// \param a first \param A its pose \param b second \param B its pose
/// \return true if b comes first \ingroup detection
bool comesSecond(const HullView& a, const Pose& A, const HullView& b, const Pose& B);

}  // namespace detail
}  // namespace carom
