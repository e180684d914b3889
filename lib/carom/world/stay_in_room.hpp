#pragma once
// What of a body that is thrown farther than anybody looked for what it may meet?
//
// Pairs are found at the start of a step, from how far each body goes and how far others can throw
// it (update_contacts.hpp). Several blows in one step, or one by something far heavier, may throw a
// small body farther. Beside others that shows as overlap, and is taken away later; a wall it would
// pass for good.
// Method: before a body makes its last way of the step, the trees are asked whether anything that
// cannot be moved is on it and is no pair of the body. If so, the body stops where its box ends,
// and loses the rest of its time: it keeps velocity and energy, and goes on in the next step.
// Why not find pairs again: it is rare, and islands would have to be joined in the middle of a step.
// Source: bodies that lose time at impacts: Catto, Continuous collision, GDC 2013.
// Not handled: bodies that can be moved; what they overlap is taken away later.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Moves a body to the border of its box, if it would leave it and a wall stands there, and sets its
/// clock to the end. \param state of the world \param index of the body, its accelerations set
/// \param end of the step [s] \ingroup world
void stayInRoom(WorldState& state, Index index, Real end);

}  // namespace carom::world
