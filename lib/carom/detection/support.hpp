#pragma once
// How far does a solid reach in a direction, and where?
//
// Method: one closed form per shape; for hulls the largest inner product over the corners, from
// kClimbAbove corners on by walking from corner to corner along the edges as long as that leads
// farther, which on a convex solid ends at the farthest.
// Why with ids: two support points with the same corner numbers are the same point, which lets GJK
// see that it makes no progress, and lets it start from where it ended last time.
// Source: van den Bergen 2003, chapter 3.
// Not handled: half-spaces reach without end; compounds are not convex.

#include <cstddef>
#include <cstdint>

#include "carom/core/real.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The farthest point of a shape in a direction. \ingroup detection
struct Support {
  Vector3 point = Vector3::Zero();  ///< the point [m, body]
  std::int32_t id = -1;             ///< number of the corner; -1 where a shape has no corners
};

/// From this number of corners on, walking along the edges of a hull beats looking at all corners.
/// \ingroup detection
inline constexpr std::size_t kClimbAbove = 96;

/// The farthest point of a ball. \param ball the ball
/// \param direction any length; zero counts as z [any unit, body] \return the point
/// \ingroup detection
Support supportOf(const Ball& ball, const Vector3& direction);

/// The farthest corner of a box; a zero component counts as positive. \param box the box
/// \param direction any length [any unit, body]
/// \return the corner; bit k of its id is set where it is on the positive side of axis k
/// \ingroup detection
Support supportOf(const Box& box, const Vector3& direction);

/// The farthest point of a capsule. \param capsule the capsule
/// \param direction any length; zero counts as z [any unit, body] \return the point
/// \ingroup detection
Support supportOf(const Capsule& capsule, const Vector3& direction);

/// The farthest point of a cylinder; along its axis the centre of the end. \param cylinder the
/// cylinder
/// \param direction any length [any unit, body] \return the point
/// \ingroup detection
Support supportOf(const Cylinder& cylinder, const Vector3& direction);

/// The farthest corner of a hull. \param hull the hull
/// \param direction any length [any unit, body] \param start corner where a walk begins
/// \return the corner
/// \ingroup detection
Support supportOf(const ConvexHull& hull, const Vector3& direction, std::int32_t start = 0);

/// The farthest point of any convex shape. \param shape the shape
/// \param direction any length [any unit, body] \return the point
/// \ingroup detection
Support supportOf(const ConvexShape& shape, const Vector3& direction);

/// The farthest point of a planar shape in a direction. \ingroup detection
struct PlanarSupport {
  Vector2 point = Vector2::Zero();  ///< the point [m, body]
  std::int32_t id = -1;             ///< number of the corner; -1 for a disc
};

/// The farthest point of a disc. \param disc the disc
/// \param direction any length; zero counts as y [any unit, body] \return the point
/// \ingroup detection
PlanarSupport supportOf(const Disc& disc, const Vector2& direction);

/// The farthest corner of a polygon, the first of equals. \param polygon the polygon
/// \param direction any length [any unit, body] \return the corner
/// \ingroup detection
PlanarSupport supportOf(const Polygon& polygon, const Vector2& direction);

}  // namespace carom
