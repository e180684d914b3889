#pragma once
// Where do two faces touch?
//
// Method: one face is the reference, its normal is the contact's; the other, the incident face, is
// cut by the planes that stand on the edges of the reference face. What is left lies above the
// reference face; its corners below the plane are the contact points, each with its own depth.
// Why all of them: one point in the middle carries no moment, and the deepest corner alone jumps
// across the face when a resting body tilts by a billionth.
// Source: section 5.4 ("polygon clipping"), its single point put right; Catto, GDC 2007.
// Not handled: more points than a solver wants (reduceContacts()).

#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// A point of the incident face above the reference face.
/// \ingroup manifold
struct FacePoint {
  Vector3 position = Vector3::Zero();  ///< on the incident face [m, world]
  Real separation = 0;                 ///< height over the reference plane; negative inside [m]
};

/// The corners of the common part of two faces that are not above the reference plane.
/// \param reference corners of the reference face, counter-clockwise seen from outside [m, world]
/// \param normal unit normal of the reference face, outward [1, world]
/// \param incident corners of the other face, either way round [m, world]
/// \param margin how far above the plane a corner may be and still count [m]
/// \return corners of the common part in the order of the incident face; empty if there is none
/// \throws InvalidInput if the reference face has fewer than 3 corners
/// \erratum{5.12}
/// \ingroup manifold
std::vector<FacePoint> faceContact(std::span<const Vector3> reference, const Vector3& normal,
                                   std::span<const Vector3> incident, Real margin = 0);

}  // namespace carom
