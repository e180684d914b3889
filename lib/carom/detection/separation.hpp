#pragma once
// How far apart are two solids, where, and in which direction?
//
// The answer that all methods of the chapter share: a signed distance, the unit normal from A to B,
// and one point on each solid that shows the distance. separation < 0 means overlap: moving B by
// -separation along the normal just frees it, and no shorter way does. Numerical trouble is said in
// the status, never thrown.

#include "carom/core/real.hpp"

namespace carom {

/// How a computation of a distance ended. \ingroup detection
enum class SeparationStatus {
  exact,      ///< a closed form: right to the rounding of a few operations
  converged,  ///< an iteration that could not improve its answer: right to rounding
  stalled,    ///< the iteration ran out of steps; errorBound says how far off it may be
};

/// The signed distance of two solids and what shows it. \ingroup detection
struct Separation {
  Real separation = 0;                ///< distance; negative: depth of the overlap [m]
  Vector3 normal = Vector3::UnitZ();  ///< unit, from A to B [1, world]
  Vector3 pointA = Vector3::Zero();   ///< point of A's surface [m, world]
  Vector3 pointB = Vector3::Zero();   ///< pointA + separation * normal, on B [m, world]
  SeparationStatus status = SeparationStatus::exact;  ///< how it was found
  int iterations = 0;                                 ///< support points asked for
  Real errorBound = 0;  ///< |error| of separation left by the iteration itself, not rounding [m]
};

/// The signed distance of two planar figures and what shows it. \ingroup detection
struct PlanarSeparation {
  Real separation = 0;                ///< distance; negative: depth of the overlap [m]
  Vector2 normal = Vector2::UnitY();  ///< unit, from A to B [1, world]
  Vector2 pointA = Vector2::Zero();   ///< point of A's outline [m, world]
  Vector2 pointB = Vector2::Zero();   ///< pointA + separation * normal, on B [m, world]
  SeparationStatus status = SeparationStatus::exact;  ///< how it was found
  int iterations = 0;                                 ///< support points asked for
  Real errorBound = 0;  ///< |error| of separation left by the iteration itself, not rounding [m]
};

}  // namespace carom
