#pragma once
// What if a step would give bodies energy that nobody has?
//
// Contacts take energy or leave it. A step is right to the second order, and where bodies turn by
// radians, contacts come one upon the other or sweeps end before they have gone, its error may be
// energy.
// Method: what holds an island does no work for whoever moves with it. So the energy of motion of
// the bodies, as such an observer sees it, and what they have fallen through are added up at both
// ends of the step. Where there is visibly more at the end all slow down alike, as he sees it.
// What lies in something else is lifted out of it. It pays for that with the speed along its way:
// a body that is found to have fallen too far has come too fast by just that. By a two hundredth of
// its size in a step it is lifted though it cannot pay, since what rests in the ground must come out
// of it. What is missing then all pay, and beyond that nobody is lifted.
// Why not take less than what is visible: errors of both signs belong to any method of the second
// order. Taking those of one sign away would brake a top.
// Source: conservation of energy; as a bound of a step: Smith, Kaufman, Vouga, Tamstorf, Grinspun,
// "Reflections on simultaneous impact", 2012.
// Not handled: torques of the user, and walls that move against each other or turn: they work.

#include <span>

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Begins to watch the energy of an island. \param state of the world
/// \param island in state.islands, at the start of its step \ingroup world
void watchEnergy(WorldState& state, IslandSlot& island);

/// Takes from the bodies of an island what a step has given them. \param state of the world
/// \param island at the end of its step, watched at the start
/// \param starts where its bodies were then, one for each [world]
/// \param duration of the step [s] \ingroup world
void keepEnergy(WorldState& state, const IslandSlot& island, std::span<const Pose> starts,
                Real duration);

/// The first half of keepEnergy(); from several threads at once. \param state of the world
/// \param island as above \param starts as above \param duration of the step [s]
/// \return share of its speed that it may keep, kAllSpeed for all of it [1] \ingroup world
Real keptShare(const WorldState& state, const IslandSlot& island, std::span<const Pose> starts,
               Real duration);

/// A share that takes nothing away. \ingroup world
inline constexpr Real kAllSpeed = 2;

/// The second half. \param state of the world \param island as above
/// \param share from keptShare(), not kAllSpeed \param duration of the step [s] \ingroup world
void slowDown(WorldState& state, const IslandSlot& island, Real share, Real duration);

/// How much of the ways by which bodies are to be moved out of overlaps can be paid for. That much
/// is paid. \param state of the world; the ways stand for velocities in work.moving
/// \param bodies all of an island that is watched, at least one \return share [1] \ingroup world
Real paidShare(WorldState& state, std::span<const Index> bodies);

/// Lets a body pay for being moved out of an overlap against what acts on it.
/// \param state of the world \param island of the body, watched \param body has been moved
/// \param way by this [m, world] \ingroup world
void payForWay(const WorldState& state, IslandSlot& island, BodySlot& body, const Vector3& way);

}  // namespace carom::world
