#pragma once
// What does a solver have to know about two bodies that touch?
//
// One normal, and up to four points that each say how deep they are. The source calls the manifold
// the area of contact; engines keep the corners of that area, because a rigid body that is held at
// the corners is held everywhere. Area and centroid of the whole contact are kept beside them, for
// friction and pressure, from before the corners were reduced to four.
// Convention: the normal points from A to B; separation < 0 means overlap (docs/notation.md).
// Not handled: several normals at once; a compound has one manifold per pair of parts.

#include <array>
#include <cstdint>

#include "carom/core/real.hpp"

namespace carom {

/// One point of a contact. \ingroup manifold
struct ManifoldPoint {
  Vector3 position = Vector3::Zero();  ///< halfway between the two surfaces [m, world]
  Real separation = 0;                 ///< along the normal, negative inside [m]
  std::uint32_t id = 0;                ///< name that persists, see contactIds()
};

/// Where two convex bodies touch. \ingroup manifold
struct Manifold {
  Vector3 normal = Vector3::UnitZ();       ///< unit, from A to B [1, world]
  std::array<ManifoldPoint, 4> points;     ///< the first `count` are valid
  int count = 0;                           ///< number of points, 0 to 4; 0: no contact
  Real area = 0;                           ///< of the contact, seen along the normal [m^2]
  Vector3 areaCentroid = Vector3::Zero();  ///< its centre, halfway between the surfaces [m, world]
};

/// The point of A's surface that belongs to a contact point.
/// \param normal of the manifold \param point one of its points
/// \return point on A [m, world]
/// \ingroup manifold
inline Vector3 pointOnA(const Vector3& normal, const ManifoldPoint& point) {
  return point.position - point.separation / 2 * normal;
}

/// The point of B's surface that belongs to a contact point.
/// \param normal of the manifold \param point one of its points
/// \return point on B [m, world]
/// \ingroup manifold
inline Vector3 pointOnB(const Vector3& normal, const ManifoldPoint& point) {
  return point.position + point.separation / 2 * normal;
}

}  // namespace carom
