#pragma once
// In how many parts is a step cheapest, if a crowd flies about in it?
//
// Whom a body may meet in a step is looked for in a box that holds all it can reach. Boxes grow with
// the step in all three directions, and in a crowd in flight the pairs that they make grow much
// faster than the step gets longer: then two steps of half the length cost less than one.
// Method: pairs are not counted but expected, as if bodies were spread evenly over the box that
// holds them all. That is one look at each body; finding the pairs could take a thousand times that.
// Source: the mean number of neighbours in a gas; event-driven simulations choose their cells by the
// same balance (Rapaport, The Art of Molecular Dynamics Simulation, 2004, chapter 14).
// Not handled: bodies of very different sizes or speeds, of which a mean knows little.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// In how many parts of equal length a time is gone cheapest. One, where few bodies move, and where
/// nobody asks when they meet. \param state of the world \param time positive [s]
/// \return a power of two up to 64 \ingroup world
int partsForCrowd(const WorldState& state, Real time);

}  // namespace carom::world
