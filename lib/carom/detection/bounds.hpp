#pragma once
// Which axis-aligned box holds a body where it is now?
//
// Method: how far the body reaches along each world axis, forwards and backwards, in closed form: a
// turned box reaches the sum of its half lengths times the absolute entries of the matrix's row, a
// cylinder its half height times the cosine plus its radius times the sine of the axis's angle.
// Why: it is tight, and cheaper than support points.
// Not handled: room for the motion of a step (chapter 8 adds it).

#include "carom/detection/aabb.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The tight axis-aligned box of a body.
/// \param shape usable shape \param pose of the body
/// \return the box [m, world]; a half-space reaches to infinity, except where its plane is square
///   to an axis
/// \ingroup detection
Aabb<3> boundsOf(const Shape& shape, const Pose& pose);

/// The tight axis-aligned box of a convex part.
/// \param shape usable shape \param pose of the part, world from part \return the box [m, world]
/// \ingroup detection
Aabb<3> boundsOf(const ConvexShape& shape, const Pose& pose);

/// The tight axis-aligned rectangle of a planar body.
/// \param shape usable shape \param pose of the body \return the rectangle [m, world]
/// \ingroup detection
Aabb<2> boundsOf(const PlanarShape& shape, const PlanarPose& pose);

}  // namespace carom
