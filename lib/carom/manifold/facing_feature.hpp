#pragma once
// Which part of a body looks into a direction: a face, a line, or a point?
//
// Method: the face of a box or hull that is within a few degrees of the direction, or else such an
// edge; the cap or the line of a cylinder, the line of a capsule; and if none is, the farthest
// point. Two such features make the manifold of any two convex bodies once the normal is known.
// A cap is a polygon of 32 corners that turn with the body, so that the points of a cylinder that
// stands still keep their names.
// Source: the supporting faces of Jolt (Rouwe) and of Bullet's polyhedral clipping.
// Not handled: the deepest point of a tilted cap lies between two corners; whoever asked for the
// normal knows it, and adds it.

#include <cstdint>

#include "carom/core/real.hpp"
#include "carom/detection/pose.hpp"
#include "carom/manifold/shape_view.hpp"

namespace carom::detail {

/// Faces and lines within 8 degrees of square to the normal are contacts of their whole extent.
/// \ingroup manifold
inline constexpr Real kFacingCosine = 0.99;
/// The sine of the same angle. \ingroup manifold
inline constexpr Real kFacingSine = 0.14106735979665885;
/// Corners of the polygon that stands for the cap of a cylinder. \ingroup manifold
inline constexpr int kCapCorners = 32;

/// Corners of the feature of a body that looks into a direction. Without initial values.
/// \ingroup manifold
struct FacingFeature {
  static constexpr int kMost = 128;  ///< corners that a face may have
  int count;                         ///< 1: a point, 2: a line, 3 or more: a face
  Vector3 corners[kMost];            ///< in order, counter-clockwise seen from outside [m, world,
                                     ///< relative to an origin that the caller chose]
  std::uint32_t cornerNames[kMost];  ///< name of the feature at each corner, see contactIds()
  std::uint32_t edgeNames[kMost];    ///< name of the edge from each corner to the next
  std::uint32_t faceName;            ///< name of the face, if it is one
  Vector3 normal;                    ///< of the face, outward [1, world]; set for faces only
};

/// The feature of a body that looks into a direction.
/// \param shape the body
/// \param R its rotation, world from body
/// \param place its origin [m, world, relative to the caller's origin]
/// \param direction unit [1, world]
/// \param feature receives it
/// \ingroup manifold
void facingFeature(const ShapeView& shape, const Matrix3& R, const Vector3& place,
                   const Vector3& direction, FacingFeature& feature);

}  // namespace carom::detail
