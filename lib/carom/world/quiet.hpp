#pragma once
// Which bodies of a pile can nothing touch until when?
//
// Method: a body is quiet until it can first touch something. Two quiet bodies come nearer only by
// the difference of their velocities and by their turning, however fast both fall. If that may
// close the gap between their boxes, they are not quiet at all. Any other may be met by one that is
// not quiet any more and so may be slower, or faster, than it was: the gap then closes as fast as
// both go, and the body is quiet until then. What is not quiet spreads so from body to body, as the
// wave that goes up a column when its foot comes to rest; each takes its part of the step.
// Why: of bodies that fall side by side, none can touch another in this step, and yet each has
// others within the way that it goes. Their manifolds are not made.
// An island that turns out to be no pile after all gets the manifolds that are missing.
// What is left out is left out by proof, under the premise of all margins: that nothing goes
// farther in a step than its velocity at the start takes it.
// Source: own; the order is that of the shortest paths of Bellman 1958 and Ford 1956.
// Not handled: pairs with what cannot be moved, and islands that went by events in the last step:
// theirs are made.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Finds out until when bodies are quiet, and takes pairs of piles that cannot touch in this step
/// from those that want a manifold. \param state of the world; pairs are in work.toMake
/// \param dt length of the step [s] \ingroup world
void leaveQuietPairs(WorldState& state, Real dt);

/// How near the two bodies of a pair can come in this step, by what is known of their quiet.
/// \param state of the world \param pair of a pile \return [m]; infinite if nothing is known
/// \ingroup world
Real quietReach(const WorldState& state, const PairSlot& pair);

}  // namespace carom::world
