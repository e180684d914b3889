#pragma once
// Where do two edges touch, and in which direction?
//
// Method: the contact of two crossing edges lies on the common perpendicular of their lines: two
// equations say that the connection is perpendicular to both. Its direction is the cross product of
// the edges, not a mean of the normals of the faces beside them, as the source has it: only along
// the cross product can the edges slide past each other without coming nearer.
// Parallel edges have no single common perpendicular; the two equations become one and the division
// 0/0. Then the axis that was handed in is the normal, and the middle of the common part is the
// point: halfway along the stretch where both edges run side by side.
// Source: section 5.4, put right; Ericson, Real-Time Collision Detection 2005, section 5.1.9.
// Not handled: edges whose lines come nearest beyond their ends; the points then stay at the ends.

#include "carom/core/real.hpp"

namespace carom {

/// The contact of two edges.
/// \ingroup manifold
struct EdgeContact {
  Vector3 normal = Vector3::UnitZ();  ///< unit, from A to B [1, world]
  Real separation = 0;                ///< from point to point along the normal [m]
  Vector3 pointA = Vector3::Zero();   ///< nearest point of A's edge [m, world]
  Vector3 pointB = Vector3::Zero();   ///< nearest point of B's edge [m, world]
  Real s = 0;                         ///< pointA = a0 + s (a1 - a0), between 0 and 1
  Real t = 0;                         ///< pointB = b0 + t (b1 - b0), between 0 and 1
};

/// The contact of an edge of A with an edge of B.
/// \param a0 start of A's edge [m, world]
/// \param a1 end of A's edge, not a0 [m, world]
/// \param b0 start of B's edge [m, world]
/// \param b1 end of B's edge, not b0 [m, world]
/// \param axis unit, roughly from A to B: says which of the two directions of the perpendicular is
///   the normal, and is the normal for parallel edges [1, world]
/// \return normal, separation and the two points
/// \throws InvalidInput if an edge has no length
/// \erratum{5.15}
/// \ingroup manifold
EdgeContact edgeContact(const Vector3& a0, const Vector3& a1, const Vector3& b0, const Vector3& b1,
                        const Vector3& axis);

}  // namespace carom
