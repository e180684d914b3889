#pragma once
// When do two moving things touch for the first time, and how sure is that?
//
// The answer that all methods of the chapter share. A hit has a time that is never later than the
// first contact and a gap that is left at that time, which is what the time may be early by. There
// is no answer "probably": a method that runs out of steps says so, and how far it has come without
// contact; whoever treats that as a hit is safe.

#include "carom/core/real.hpp"

namespace carom {

/// What became of a search for the first contact. \ingroup toi
enum class ImpactStatus {
  kHit,          ///< they come to touch at `time`
  kNoHit,        ///< they do not touch, for certain
  kOverlapping,  ///< they overlap at the start already
  kLimit,        ///< the search ended at `time`: no contact until then, nothing known of later
};

/// The first contact of two moving bodies. \ingroup toi
struct TimeOfImpact {
  ImpactStatus status = ImpactStatus::kNoHit;  ///< what became of the search
  Real time = 0;                               ///< of the hit, from the start of the motion [s]
  Vector3 point = Vector3::Zero();             ///< where they touch then [m, world]
  Vector3 normal = Vector3::UnitZ();           ///< unit, from A to B [1, world]
  Real gap = 0;   ///< left between them at that time; negative: depth [m]
  int steps = 0;  ///< advances made
};

}  // namespace carom
