#pragma once
// Where do any two convex bodies touch?
//
// Method: GJK and EPA give the normal, the depth and a pair of witness points. Then the features
// that look along the normal are held against each other: face on face and line on face are
// clipped, line along line keeps the ends of the common part, and everything else touches at the
// witness points alone. The witness is always among the points.
// Why not for boxes and hulls: separating axes give their exact normal faster.
// No cache: the normal must not depend on where an iteration started.
// Source: Gilbert, Johnson and Keerthi 1988; van den Bergen 2001; for the features Jolt.
// Not handled: contacts of curved sides that are nearly parallel over more than a line.

#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/shape_view.hpp"

namespace carom {

/// The manifold of two convex bodies, from their distance and the features along its normal.
/// \param a first body
/// \param A its pose
/// \param b second body
/// \param B its pose
/// \param margin surfaces up to this far apart still make points, with positive separation [m]
/// \return manifold; no points if the bodies are more than the margin apart
/// \ingroup manifold
Manifold collideFeatures(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                         Real margin = 0);

namespace detail {

/// collideFeatures() of shapes that are not copied.
/// \param a view of A's shape \param A its pose \param b view of B's shape \param B its pose
/// \param margin as there \return as there \ingroup manifold
Manifold collideFeaturesOf(const ShapeView& a, const Pose& A, const ShapeView& b, const Pose& B,
                           Real margin);

}  // namespace detail
}  // namespace carom
