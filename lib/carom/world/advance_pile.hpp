#pragma once
// How do large piles go on by a step?
//
// Method: as it stands, without looking for events: what has touched and what may touch within the
// step are contacts of soft steps (solver/soft_steps.hpp). A body that no contact has moved goes on
// as if alone, in closed form.
// Why: looking for each impact and each end of a slip costs the square of the bodies in a heap, and
// thousands of contacts do not need the last digit of one.
// Why all piles at once: blocks of eight contacts and loops of threads do not ask to which pile a
// contact belongs. A hundred piles of two balls each would leave most lanes empty. What one pile
// comes to does not depend on the others, not even in its last bit: a contact's colour depends on
// the contacts of its own bodies, and those between bodies that move come first in any case.
// Not handled: which islands are large (advance_island.cpp).

#include <span>

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Advances islands by soft steps. \param state of the world \param islands their numbers
/// \param start in this step, at which their bodies are [s] \param until in this step, later [s]
/// \ingroup world
void advancePiles(WorldState& state, std::span<const Index> islands, Real start, Real until);

}  // namespace carom::world
