#pragma once
// How does a body move during one step?
//
// Method: its centre of mass on a parabola, and around it a steady turn:
//   c(t) = c(0) + v t + a t^2 / 2,   R(t) = exp(w t) R(0).
// Why so simple: these are the motions for which the search for the first contact can promise
// never to be late. Gravity is in it exactly; a tumbling body is followed in steps so short that
// its angular velocity may be taken as steady.
// Why not straight lines for all points: a point of a turning body moves on an arc. The chord cuts
// the arc, and what the arc would have hit is missed (case T12: the tip of a blade passes a ball).
// Not handled: bodies that change shape, or turn unsteadily within a step.

#include "carom/detection/pose.hpp"

/// \defgroup toi Time of impact: chapter 7
/// When moving bodies touch for the first time.

namespace carom {

/// The motion of a rigid body from time zero on. \ingroup toi
struct Sweep {
  Pose start;                                 ///< where it is at time zero
  Vector3 velocity = Vector3::Zero();         ///< of the centre at time zero [m/s, world]
  Vector3 angularVelocity = Vector3::Zero();  ///< steady [rad/s, world]
  Vector3 acceleration = Vector3::Zero();     ///< of the centre, steady [m/s^2, world]
  Vector3 centre = Vector3::Zero();           ///< the point that it turns about [m, body]
};

/// How far the centre has come after a while.
/// \param sweep its motion \param time from the start [s]
/// \return way from where it was at time zero [m, world]
/// \ingroup toi
inline Vector3 travelled(const Sweep& sweep, Real time) {
  return time * sweep.velocity + time * time / 2 * sweep.acceleration;
}

/// Where a body is after a while.
/// \param sweep its motion \param time from the start [s]
/// \return its pose; at time zero the very one it started with
/// \ingroup toi
Pose poseAt(const Sweep& sweep, Real time);

/// How fast a point of a body moves after a while.
/// \param sweep its motion \param time from the start [s]
/// \param point fixed in the body, where it is at that time [m, world]
/// \return velocity of the point [m/s, world]
/// \ingroup toi
Vector3 velocityAt(const Sweep& sweep, Real time, const Vector3& point);

/// Refuses a motion that cannot be worked with. \param sweep any motion
/// \param name what it is called, for the message
/// \throws InvalidInput if a number is not finite or the pose is not rigid
/// \ingroup toi
void requireUsable(const Sweep& sweep, const char* name);

}  // namespace carom
