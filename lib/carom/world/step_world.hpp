#pragma once
// One step, as a table. A crowd in flight goes it in several parts (crowd.hpp).
//
// | stage             | reads                          | writes                                  |
// | updatePairs       | where awake bodies can be      | pairs that began and ended              |
// | updateManifolds   | poses, shapes, old manifolds   | manifolds, islands joined, bodies woken |
// | splitIslands      | pairs that ended               | islands, in order                       |
// | advanceIslands    | islands that are awake         | their bodies at the end of the step     |
// | advanceFree       | bodies that nothing is near    | their state at the end, exactly         |
// | reportContacts    | manifolds                      | events                                  |
// | sleepIslands      | how bodies have moved          | who is awake                            |
//
// Each stage is a function in a file of its own. None of them looks at what sleeps or never moves.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Forgets what the last step counted and told of. \param state of the world
/// \param dt length of the step [s] \ingroup world
void beginStep(WorldState& state, Real dt);

/// Tells of contacts that have begun and ended, all events in order. \param state of the world
/// \ingroup world
void reportContacts(WorldState& state);

/// Counts who is awake. \param state of the world \ingroup world
void countBodies(WorldState& state);

/// Moves everything on. \param state of the world \param dt length of the step, positive [s]
/// \ingroup world
void stepWorld(WorldState& state, Real dt);

}  // namespace carom::world
