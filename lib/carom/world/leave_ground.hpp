#pragma once
// When does a ball roll off a face, and does it fly then?
//
// Method: the point below its middle goes on a parabola; where that crosses a side behind which the
// ground bends away or ends, the face lets go of it. On the edge itself it stays if gravity presses
// it down by more than it takes to go round, v^2 / r; else it flies. So a fast ball leaves a
// table at its rim, and not one step later.
// Why only balls: a box does not leave a face at one moment.
// Source: the circle's acceleration, Huygens 1673; the events are those of advance_island.hpp.
// Not handled: ridges of less than a thousandth of a radian, over which the face holds until the
// end of the step; the turning of the normal within a step while a ball goes round a ridge.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Drops the contact of a ball that goes over an edge. \param state of the world
/// \param pair of a piece of ground and a ball, its manifold made \param ground pose of the piece
/// \ingroup world
void leaveGround(const WorldState& state, PairSlot& pair, const Pose& ground);

/// When a ball on a face comes to an edge over which it leaves it. \param state of the world
/// \param pair of a face and a ball \param ground pose of the face
/// \return from now on; infinite if never [s] \ingroup world
Real timeToEdge(const WorldState& state, const PairSlot& pair, const Pose& ground);

/// The time at which a body may meet a piece of ground next: from the front, and where the ground
/// is. \param state of the world, with accelerations set \param index of the pair
/// \param time in this step from which to look \param end end of the step [s]
/// \param followed time from now on until a point of the manifold closes, infinite if none does [s]
/// \return time in this step; infinite if they do not meet [s] \ingroup world
Real nextGroundContact(WorldState& state, Index index, Real time, Real end, Real followed);

}  // namespace carom::world
