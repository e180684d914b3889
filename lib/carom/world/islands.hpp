#pragma once
// How are islands kept while contacts come and go?
//
// Method: a pair that begins joins two islands at once: the smaller one's bodies and pairs move
// over to the larger one. A pair that ends leaves its island marked; before the next time that the
// island is stepped it is looked through (find_islands.hpp), and what has come apart gets islands
// of its own. A body that no pair holds has no island.
// Why not all anew in each step: in a quiet scene nothing begins or ends, and nothing is done.
// An island sleeps or wakes as a whole. What is awake stands in lists, and nothing else is looked
// at.
// Source: Catto, Simulation islands, 2023 (lists that are joined at once and split when needed).
// Not handled: the order within an island is by ids, made when it is needed, so that a scene gives
// the same numbers whatever else there is in the world.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// The name by which pairs are put into order: it depends on the bodies of their island alone, and
/// not on when the ground under them was added. \param state of the world \param pair whose shapes
/// are known
/// \return names compare as the pairs should, and never change \ingroup world
std::uint64_t orderOf(const WorldState& state, const PairSlot& pair);

/// Lets a pair hold its bodies together. \param state of the world \param pair that is not held yet
/// \ingroup world
void joinByPair(WorldState& state, Index pair);

/// Lets a pair go. \param state of the world \param pair that holds \ingroup world
void releasePair(WorldState& state, Index pair);

/// Looks through the islands that may have come apart, and brings the others into order.
/// \param state of the world \ingroup world
void splitIslands(WorldState& state);

/// Wakes an island. \param state of the world \param island that may sleep \ingroup world
void wakeIsland(WorldState& state, Index island);

/// Wakes a body and its island. \param state of the world \param body that may sleep
/// \ingroup world
void wakeBody(WorldState& state, Index body);

/// Puts an island to sleep. \param state of the world \param island that is awake \ingroup world
void putToSleep(WorldState& state, Index island);

/// Takes a body out of its island. \param state of the world \param body that no pair holds
/// \ingroup world
void leaveIsland(WorldState& state, Index body);

/// Adds a body to the list of those awake. \param state of the world \param body not in it
/// \ingroup world
void listBody(WorldState& state, Index body);

/// Takes a body out of the list of those awake. \param state of the world \param body in it
/// \ingroup world
void unlistBody(WorldState& state, Index body);

/// Brings the list of pairs up to date: a pair is in it if a body of it is awake.
/// \param state of the world \param pair any that is alive \ingroup world
void listPair(WorldState& state, Index pair);

/// Lets islands sleep that have been at rest for long enough. \param state of the world
/// \param dt length of the step that has just been made [s] \ingroup world
void sleepIslands(WorldState& state, Real dt);

}  // namespace carom::world
