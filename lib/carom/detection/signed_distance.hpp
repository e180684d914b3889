#pragma once
// How far apart, or how deep in each other, are two solids of any kind?
//
// Method: the best way for each pair. Balls: a point against the other's surface, in closed form.
// Capsules: segment against segment. Half-spaces: how far the other reaches against the normal.
// Everything else: GJK, and EPA where the bodies overlap. Polyhedra so near to touching that
// rounding decides get their verdict from the exact separating axes. Compounds: the nearest, or
// deepest, pair of parts.
// Why one door: a caller need not know which pair is which, and swapping the arguments gives the
// mirrored answer.
// Source: Ericson 2005; van den Bergen 2003.
// Not handled: the least way to free overlapping compounds (the deepest pair of parts only); which
// of several equally near pairs of points is reported.

#include "carom/core/real.hpp"
#include "carom/detection/gjk.hpp"
#include "carom/detection/planar_shapes.hpp"
#include "carom/detection/pose.hpp"
#include "carom/detection/separation.hpp"
#include "carom/detection/shapes.hpp"

namespace carom {

/// The signed distance of two solids.
/// \param a usable shape of A \param A its pose
/// \param b usable shape of B \param B its pose
/// \param cache if given, where to start and to remember where it ended; for pairs of convex
///   shapes, kept per pair
/// \return separation, unit normal from A to B, a point on each, and a status. Two half-spaces that
///   are not opposite overlap without end: separation -infinity, points zero
/// \throws InvalidInput if a pose is not finite
/// \source{20,21,22}
/// \ingroup detection
Separation signedDistance(const Shape& a, const Pose& A, const Shape& b, const Pose& B,
                          SimplexCache* cache = nullptr);

/// The signed distance of two convex parts.
/// \param a usable shape of A \param A its pose
/// \param b usable shape of B \param B its pose
/// \param cache as for any shapes
/// \return as for any shapes
/// \throws InvalidInput if a pose is not finite
/// \ingroup detection
Separation signedDistance(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                          SimplexCache* cache = nullptr);

/// The signed distance of two planar figures.
/// \param a usable shape of A \param A its pose
/// \param b usable shape of B \param B its pose
/// \return separation, unit normal from A to B, a point on each, and a status
/// \throws InvalidInput if a pose is not finite
/// \ingroup detection
PlanarSeparation signedDistance(const PlanarShape& a, const PlanarPose& A, const PlanarShape& b,
                                const PlanarPose& B);

}  // namespace carom
