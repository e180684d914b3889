#pragma once
// When does a vertex hit a face, or an edge an edge, if all points move in straight lines?
//
// In three steps, of which nearly every query needs only the first. (1) Doubles with error bounds:
// features that a coordinate axis keeps apart at both ends of the motion are apart in between;
// the cubic of moving_points.hpp has no root where its Bernstein coefficients agree in sign; areas
// with opposite signs show that a vertex passes beside a face. Intervals of time about which
// nothing certain can be said are halved a few times. (2) A root that is certain to be a hit is
// sharpened with twice the digits. (3) What stays open - features that just touch, motion in one
// plane, triangles without area - is decided in whole numbers (exact_contact.hpp).
// Why this way: the cubic with a tolerance (Provot 1997) drops hits. Interval arithmetic alone
// (Wang et al. 2021) never does, but near misses cost it milliseconds, and it answers hit when it
// gives up. Brochu, Edwards and Bridson (2012) answer exactly whether there is a hit, but not when.
// The time is the exact first time of contact, rounded down to a double: it is never late, and less
// than one unit in the last place early. Touching counts as a hit, also at the start and the end.
// Not handled: points on curved paths; a thickness of the surfaces.

#include "carom/toi/moving_points.hpp"
#include "carom/toi/time_of_impact.hpp"

namespace carom {

/// Which part of the method had the last word. \ingroup toi
enum class DecidedBy {
  kAxes,          ///< a coordinate axis separates the motions
  kFilter,        ///< doubles with error bounds
  kDoubleDouble,  ///< a hit whose time was sharpened with twice the digits
  kExact,         ///< whole numbers
};

/// The first contact of two features. \ingroup toi
struct FeatureImpact {
  /// kHit or kNoHit. Point, normal and gap are those of the features at `time`, rounded.
  TimeOfImpact impact;
  /// Of the four points, in their order. Vertex and face: 1, then the weights of the corners. Two
  /// edges: those of both ends of the first, then of both ends of the second.
  std::array<Real, 4> weights = {};
  DecidedBy decidedBy = DecidedBy::kAxes;  ///< for those who count
};

/// When a vertex and a triangle touch for the first time. The normal points from the vertex (A) to
/// the side of the triangle (B) that it does not come from.
/// \param points point 0 is the vertex, 1 to 3 the corners of the triangle, in any order; any
///   finite ones, also those of triangles without area
/// \return hit or not, never a guess; the time is the exact one rounded down
/// \throws InvalidInput if a coordinate is not finite
/// \erratum{8.5}
/// \ingroup toi
FeatureImpact vertexFaceImpact(const MovingPoints& points);

/// When two edges touch for the first time. The normal points from the first edge (A) to the side
/// of the second (B) that it does not come from.
/// \param points 0 and 1 are the ends of the first edge, 2 and 3 those of the second; any finite
///   ones, also those of edges without length and of parallel edges
/// \return hit or not, never a guess; the time is the exact one rounded down
/// \throws InvalidInput if a coordinate is not finite
/// \erratum{8.5}
/// \ingroup toi
FeatureImpact edgeEdgeImpact(const MovingPoints& points);

}  // namespace carom
