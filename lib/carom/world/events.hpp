#pragma once
// What happened in the last step that a user may want to hear of?
//
// Three lists: pairs of shapes that began to touch, pairs that ended, and impacts, each in the
// order in which it happened, and for equal times by ids. They are valid until the next step.

#include <cstdint>
#include <span>

#include "carom/core/real.hpp"
#include "carom/world/ids.hpp"

namespace carom::world {

/// A pair of shapes that began or ended to touch. \ingroup world
struct ContactEvent {
  ShapeId shapeA;  ///< one shape
  ShapeId shapeB;  ///< the other
  BodyId bodyA;    ///< body of shapeA
  BodyId bodyB;    ///< body of shapeB
};

/// An impact of two shapes. \ingroup world
struct ImpactEvent {
  ShapeId shapeA;                    ///< one shape
  ShapeId shapeB;                    ///< the other
  BodyId bodyA;                      ///< body of shapeA
  BodyId bodyB;                      ///< body of shapeB
  Real time = 0;                     ///< from the start of the step [s]
  Vector3 point = Vector3::Zero();   ///< where [m, world]
  Vector3 normal = Vector3::Zero();  ///< unit, from A to B [1, world]
  Real approach = 0;                 ///< speed of approach before it [m/s]
  Real impulse = 0;                  ///< along the normal [N s]
  std::int32_t number = 0;           ///< in the order in which the step found them
};

/// What happened in the last step. \ingroup world
struct Events {
  std::span<const ContactEvent> begun;   ///< pairs that touch and did not before
  std::span<const ContactEvent> ended;   ///< pairs that touched and do not any more
  std::span<const ImpactEvent> impacts;  ///< impacts at their times
};

}  // namespace carom::world
