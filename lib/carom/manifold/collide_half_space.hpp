#pragma once
// Where does a body touch a floor?
//
// Method: the normal is the floor's, so there is nothing to search: the face, line or point of the
// body that looks at the floor (facing_feature.hpp) is held against the plane, and what is below it
// touches. The farthest point is always among the points.
// Why all corners of a face: a box that tilts by a billionth keeps its four points, and their
// depths change by a billionth; the deepest one alone would jump from side to side.
// Not handled: a half-space against a half-space.

#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/shape_view.hpp"

namespace carom {

/// The manifold of a half-space and a convex body.
/// \param a the half-space
/// \param A its pose
/// \param b the body
/// \param B its pose
/// \param margin surfaces up to this far apart still make points, with positive separation [m]
/// \return manifold; no points if the body is more than the margin above the plane
/// \ingroup manifold
Manifold collideHalfSpace(const HalfSpace& a, const Pose& A, const ConvexShape& b, const Pose& B,
                          Real margin = 0);

namespace detail {

/// collideHalfSpace() of a body that is not copied.
/// \param a the half-space \param A its pose \param b view of the body's shape \param B its pose
/// \param margin as there \return as there \ingroup manifold
Manifold collideHalfSpaceWith(const HalfSpace& a, const Pose& A, const ShapeView& b, const Pose& B,
                              Real margin);

}  // namespace detail
}  // namespace carom
