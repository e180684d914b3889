#pragma once
// What do bodies that touch do until something changes?
//
// Method: as long as no contact begins, ends, sticks or slips, forces and accelerations are nearly
// constant. So the contacts are solved once, for the velocities at the end of the time, and the
// bodies move by the mean of the velocities at both ends. For a block that slides, a ball that
// slips and anything that rests this is exact; otherwise its error goes with the square of the
// step, and a body that turns about an edge takes short phases (advance_island.cpp). For that the
// solver looks at the contacts as they will be: impulses act at the arms of the middle of the time,
// and velocities are asked for at its end. Arms turn with the body whose corner it is; a ball's arm
// stays below its middle, and on the line of both middles where two balls go round each other.
// The end of slipping is found on the way: slip changes evenly, so its time is a division.
// Source: the trapezoidal rule; Jean 1999 for contacts with a midpoint; stop times: chapter 5.
// Not handled: that two balls go round each other on a circle. Here it is a parabola, which is off
// by the fourth power of the angle (project_positions.hpp closes that gap).

#include <span>

#include "carom/world/world_state.hpp"

namespace carom::world {

/// How a phase is to be solved. \ingroup world
struct PhaseTask {
  std::span<const Index> bodies;  ///< dynamic ones, ascending, all at the time `start`
  std::span<const Index> pairs;   ///< with manifolds of that time
  Real start = 0;                 ///< in this step [s]
  Real end = 0;                   ///< end of the step [s]
  /// Points that are apart are rows, too, and may close until the end. Without it only closed
  /// points are, and others are left to the search for events.
  bool speculative = false;
};

/// Solves the contacts of a set of bodies until the end of the step: accelerations and velocities
/// at the end are set in the bodies, forces in the pairs. A pair whose slipping ends before has
/// that time in `stop`. \param state of the world \param task what to solve
/// \return whether the sweeps came to an end; if not, times and small speeds mean little
/// \ingroup world
bool solvePhase(WorldState& state, const PhaseTask& task);

/// Gives each body of a set its number, and lists it with its velocity. Immovable and kinematic
/// bodies of the pairs follow. \param state of the world \param bodies dynamic ones
/// \param pairs of these \ingroup world
void gather(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs);

/// The fastest thing in the set: what changes by less than a rounding of it has come to an end. What
/// turns on the spot is fast as well, because slips of its surface have roundings of that.
/// \param work its moving bodies \param least if nothing moves [m/s] \return speed, positive [m/s]
/// \ingroup world
Real fastestOf(const Workspace& work, Real least);

/// Solves the blocks that are prepared, and counts what it took. \param state of the world, gathered
/// \param scale what is fast [m/s] \param strikes whether this is an impact
/// \return whether they settled \ingroup world
bool solveBlocks(WorldState& state, Real scale, bool strikes = false);

/// Speed below which nothing is an impact: bounces that are slower end within the shortest time.
/// \param state of the world \return [m/s] \ingroup world
Real slowSpeed(const WorldState& state);

/// How fast a point of a pair's manifold parts. \param state of the world, all bodies of the pair
/// at the time of the manifold \param pair which \param point its number \return [m/s]
/// \ingroup world
Real partingSpeed(const WorldState& state, const PairSlot& pair, int point);

/// Whether a phase holds a point of a pair: it is closed and does not part.
/// \param state of the world, all bodies of the pair at the time of the manifold \param pair which
/// \return true if it does \ingroup world
bool isHeld(const WorldState& state, const PairSlot& pair);

/// A pair as the solver wants it, at the start of the time. \param state of the world, gathered
/// \param pair its index \return patch without points \ingroup world
WorkPatch patchOf(const WorldState& state, Index pair);

/// Takes a point of the manifold into a patch. \param work patch of its pair, with room
/// \param pointOfManifold its number there \param point as the solver wants it \ingroup world
void addPoint(WorkPatch& work, int pointOfManifold, const PatchPoint& point);

/// The arms of a point of a manifold. \param state of the world \param pair which
/// \param point its number \return point with both arms \ingroup world
PatchPoint armsOf(const WorldState& state, const PairSlot& pair, int point);

}  // namespace carom::world
