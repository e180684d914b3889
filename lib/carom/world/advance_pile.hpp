#pragma once
// How does a large pile go on by a step?
//
// Method: as it stands, without looking for events: what has touched and what may touch within the
// step are contacts of soft steps (solver/soft_steps.hpp). A body that no contact has moved goes on
// as if alone, in closed form.
// Why: looking for each impact and each end of a slip costs the square of the bodies in a heap, and
// thousands of contacts do not need the last digit of one.
// Not handled: which islands are large (advance_island.cpp).

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Advances an island by soft steps. \param state of the world \param island its number
/// \param start in this step, at which its bodies are [s] \param until in this step, later [s]
/// \ingroup world
void advancePile(WorldState& state, Index island, Real start, Real until);

}  // namespace carom::world
