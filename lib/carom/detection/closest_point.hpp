#pragma once
// Which point of a body's surface is nearest to a given point, and is that point inside?
//
// Method: closed forms: clamping for boxes, the nearest point of the axis for capsules, the plane
// of the axis and the point for cylinders; for hulls the face with the largest height if the point
// is inside, else the nearest of the faces that see it and of their edges.
// Why: a ball against anything is a point against anything, less a radius.
// Source: Ericson, Real-Time Collision Detection, 2005, chapter 5.
// Not handled: for a point inside several parts of a compound the surface that is reported may be
// covered by another part.

#include "carom/core/real.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// A point of a surface and how far another point is from it. \ingroup detection
struct SurfacePoint {
  Real distance = 0;                  ///< negative if the other point is inside [m]
  Vector3 point = Vector3::Zero();    ///< on the surface [m, world]
  Vector3 normal = Vector3::UnitZ();  ///< unit, outward; other = point + distance * normal [1]
};

/// The nearest point of the surface of a body.
/// \param shape usable shape \param pose of the body \param point any point [m, world]
/// \return nearest point of the surface, signed distance and outward normal; of several nearest
///   points one, the same for the same input
/// \ingroup detection
SurfacePoint closestPoint(const Shape& shape, const Pose& pose, const Vector3& point);

/// The nearest point of the surface of a convex part.
/// \param shape usable shape \param pose of the part, world from part
/// \param point any point [m, world] \return as for a Shape
/// \ingroup detection
SurfacePoint closestPoint(const ConvexShape& shape, const Pose& pose, const Vector3& point);

/// A point of an outline and how far another point is from it. \ingroup detection
struct OutlinePoint {
  Real distance = 0;                  ///< negative if the other point is inside [m]
  Vector2 point = Vector2::Zero();    ///< on the outline [m, world]
  Vector2 normal = Vector2::UnitY();  ///< unit, outward; other = point + distance * normal [1]
};

/// The nearest point of the outline of a planar body.
/// \param shape usable shape \param pose of the body \param point any point [m, world]
/// \return nearest point of the outline, signed distance and outward normal
/// \ingroup detection
OutlinePoint closestPoint(const PlanarShape& shape, const PlanarPose& pose, const Vector2& point);

/// Does a closed body hold a point? Decided by the sign of each shape's own inequality, for balls
/// and capsules exactly once the point is in body coordinates.
/// \param shape usable shape \param pose of the body \param point any point [m, world]
/// \return true inside and on the surface
/// \ingroup detection
bool contains(const Shape& shape, const Pose& pose, const Vector3& point);

/// Does a closed planar body hold a point?
/// \param shape usable shape \param pose of the body \param point any point [m, world]
/// \return true inside and on the outline
/// \ingroup detection
bool contains(const PlanarShape& shape, const PlanarPose& pose, const Vector2& point);

namespace detail {

/// closestPoint() of a ball in its own frame. \param ball the ball \param x point [m, body]
/// \return nearest point of the surface [body]
SurfacePoint closestInBody(const Ball& ball, const Vector3& x);
/// closestPoint() of a box in its own frame. \param box the box \param x point [m, body]
/// \return nearest point of the surface [body]
SurfacePoint closestInBody(const Box& box, const Vector3& x);
/// closestPoint() of a capsule in its own frame. \param capsule the capsule
/// \param x point [m, body] \return nearest point of the surface [body]
SurfacePoint closestInBody(const Capsule& capsule, const Vector3& x);
/// closestPoint() of a cylinder in its own frame. \param cylinder the cylinder
/// \param x point [m, body] \return nearest point of the surface [body]
SurfacePoint closestInBody(const Cylinder& cylinder, const Vector3& x);
/// closestPoint() of a hull in its own frame. \param hull the hull \param x point [m, body]
/// \return nearest point of the surface [body]
SurfacePoint closestInBody(const ConvexHull& hull, const Vector3& x);

}  // namespace detail
}  // namespace carom
