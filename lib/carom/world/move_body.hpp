#pragma once
// Where is a body a little later?
//
// Method: a body that nothing touches is on a parabola, exactly, and turns as a free body does: a
// ball steadily about its axis, any other in closed form from the last moment at which something
// changed its rotation (free_rotor.hpp). A body in contact has constant accelerations, found by the
// solver for this part of the step; it moves by the mean of its velocities.
// What a body does not need it does not pay: no closed form for a ball, none for what does not
// turn.
// Source: equations 1 and 16; Störmer and Verlet for the mean of the velocities.
// Not handled: what it may hit on the way (next_contact.hpp).

#include "carom/world/world_state.hpp"

namespace carom::world {

/// A body that turns farther than this while something is searched or solved is looked at more
/// closely [rad]. \ingroup world
inline constexpr Real kFastTurn = 0.25;

/// Whether a body's own turning changes its rate. \param state of the world \param body any
/// \return false if it turns evenly, or not, or gyroscopic terms are off \ingroup world
bool nutates(const WorldState& state, const BodySlot& body);

/// Whether a small error of where a body lies is a large one of its energy: it turns far in this
/// time, or is a needle, whose spin about its length is a thousandth of what it is about others for
/// the same momentum. \param body any \param rate at which it turns [rad/s, world]
/// \param duration of the time [s] \return false if the error does not matter \ingroup world
bool needsEnergyKept(const BodySlot& body, const Vector3& rate, Real duration);

/// Twice the energy with which a body turns. \param body whose moments
/// \param R_WB world from its inner frame \param rate angular velocity [rad/s, world]
/// \return [J] \ingroup world
Real turningEnergy(const BodySlot& body, const Matrix3& R_WB, const Vector3& rate);

/// A body has been turned, and its angular velocity has been left: takes of that what would give it
/// more energy than it had. \param body whose \param R_WB where it was [world from inner frame]
/// \ingroup world
void keepTurningEnergy(BodySlot& body, const Matrix3& R_WB);

/// A body at some moment. \ingroup world
struct BodyState {
  Vector3 position = Vector3::Zero();  ///< centre of mass [m, world]
  Quaternion orientation;              ///< inner frame to world
  Velocity velocity;                   ///< [world]
  Vector3 lost = Vector3::Zero();      ///< what rounding took from the position [m]
};

/// Where a shape of a body at some moment is. \param body whose, as it is now
/// \param then the body at that moment \param shape one of its shapes
/// \return world from shape; a ball about the middle of its body is not turned \ingroup world
inline Pose poseOfShape(const BodySlot& body, const BodyState& then, const ShapeSlot& shape) {
  const Quaternion &q = then.orientation, &now = body.orientation;
  // Most bodies that are looked at do not turn, or it is all the same.
  if (isCentredBall(shape) || (q.w == now.w && q.x == now.x && q.y == now.y && q.z == now.z)) {
    return placed({body.pose.R_WB, then.position}, shape);
  }
  return placed(poseOf(q, then.position), shape);
}

/// How a body lies in the middle of a time, as far as its own turning takes it. \param body whose
/// \param duration of the time [s] \return rotation, inner frame to world \ingroup world
Matrix3 middleOf(const BodySlot& body, Real duration);

/// Makes pose and inverse inertia anew from position and orientation. \param body is changed
/// \ingroup world
void refreshPose(BodySlot& body);

/// The inverse inertia of a body in a given orientation. \param body whose moments
/// \param R_WB rotation, inner frame to world \return [1/(kg m^2), world] \ingroup world
Matrix3 inverseInertiaOf(const BodySlot& body, const Matrix3& R_WB);

/// What acts on a body that nothing touches. \param state of the world \param body any
/// \return acceleration of its centre [m/s^2, world] \ingroup world
Vector3 freeAcceleration(const WorldState& state, const BodySlot& body);

/// Where a body is at a later time of this step, if nothing happens until then.
/// \param state of the world; an anchor may be made \param index of the body
/// \param time in this step, not before its clock [s] \return its state then \ingroup world
BodyState bodyAt(WorldState& state, Index index, Real time);

/// Moves a body on. \param state of the world \param index of the body
/// \param time in this step, not before its clock [s]
/// \param last whether this is the end of the step, to which the solver has computed
/// \ingroup world
void moveBody(WorldState& state, Index index, Real time, bool last = false);

/// Lets a body turn freely from a moment on. \param state of the world \param body without an
/// anchor \param anchor to give it \ingroup world
void giveAnchor(WorldState& state, BodySlot& body, const RotorAnchor& anchor);

/// Forgets that a body turned freely: something has changed its rotation.
/// \param state of the world \param body whose \ingroup world
void dropAnchor(WorldState& state, BodySlot& body);

/// The angular velocity of a body after a while without torque. \param body any
/// \param duration [s] \return [rad/s, world] \ingroup world
Vector3 turnedRate(const BodySlot& body, Real duration);

}  // namespace carom::world
