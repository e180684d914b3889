#pragma once
// Where do two planar figures touch?
//
// Method: discs by nearest points; polygons by separating axes: the best edge is the reference, the
// edge of the other that looks most against it is cut to the width of the reference, and its ends
// below the reference are the points. All of it lies at z = 0, so that the solvers need not know
// that it is planar.
// The area of a planar contact is zero; its centroid is the middle of the contact.
// Source: Catto, GDC 2006.
// Not handled: figures with holes.

#include <vector>

#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/pose.hpp"
#include "carom/manifold/collide.hpp"
#include "carom/manifold/manifold.hpp"

namespace carom {

/// The manifold of two convex planar figures.
/// \param a usable shape of A
/// \param A its pose
/// \param b usable shape of B
/// \param B its pose
/// \param margin outlines up to this far apart still make points, with positive separation [m]
/// \return manifold at z = 0 of at most two points; none if the figures are more than the margin
///   apart
/// \ingroup manifold
Manifold collidePlanar(const ConvexPlanarShape& a, const PlanarPose& A, const ConvexPlanarShape& b,
                       const PlanarPose& B, Real margin = 0);

/// The manifolds of two planar figures of any shape.
/// \param a usable shape of A
/// \param A its pose
/// \param b usable shape of B
/// \param B its pose
/// \param manifolds receives one per pair of parts that touch, ordered by part of A, then of B;
///   what was in it is lost
/// \param margin outlines up to this far apart still make points; zero or more [m]
/// \throws InvalidInput if the margin is negative
/// \ingroup manifold
void collidePlanar(const PlanarShape& a, const PlanarPose& A, const PlanarShape& b,
                   const PlanarPose& B, std::vector<PartManifold>& manifolds, Real margin = 0);

}  // namespace carom
