#pragma once
// How deep do two overlapping bodies reach into each other, and which way out is shortest?
//
// Method: EPA. A polytope inside the difference A - B grows: its face nearest to the origin is
// pushed out to the support point in the face's direction, until there is nothing farther out.
// Distances are signed, so an origin just outside (bodies that barely touch) is no special case:
// then the answer is a tiny positive separation.
// Which faces a new point sees is decided by exact signs, as for hulls of points; the failures
// reported for other implementations (faces that contradict each other, an origin "outside of the
// polytope") cannot happen.
// Source: van den Bergen 2001; exact signs after Shewchuk 1997.
// Not handled: cores whose difference has no volume (two segments, a point and a segment); closed
// forms serve those.

#include "carom/core/real.hpp"
#include "carom/detection/core_shape.hpp"
#include "carom/detection/simplex.hpp"

namespace carom::detail {

/// The face of A - B that is nearest to the origin. \ingroup detection
struct Penetration {
  Vector3 normal = Vector3::UnitZ();  ///< unit: B must move along it to be free [1, world]
  Real depth = 0;                     ///< how far; negative: they are apart by as much [m]
  Vector3 pointA = Vector3::Zero();   ///< point of A's core, from A's origin [m, world axes]
  Vector3 pointB = Vector3::Zero();   ///< point of B's core, pointA - depth * normal [m]
  int iterations = 0;                 ///< support points asked for
  Real errorBound = 0;                ///< the true depth is at least depth - errorBound [m]
  bool flat = false;                  ///< the difference has no volume; nothing else is set
};

/// Pushes bodies apart. \param pair support points of A - B
/// \param seed corners to begin with, as GJK leaves them
/// \param size largest length of coordinates that meet, for the rounding error [m]
/// \return the shortest way out
Penetration expandPolytope(const CorePair& pair, const Simplex<3>& seed, Real size);

}  // namespace carom::detail
