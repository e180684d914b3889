#pragma once
// When do two bodies meet next, within this step?
//
// Method: two that are apart have their first contact searched for (toi/first_contact.hpp), balls
// in closed form. Where they touch already that search has nothing to say: there each point of the
// manifold that is not held is followed along its parabola, a corner that comes down beside a
// corner that stands, a ball that has just bounced. When such a time comes, the manifold is made
// anew and says how things are.
// Why not always the search: a body that is too slow to meet anything in this step is left out by
// one comparison of ways.
// Not handled: points that are not in the manifold of a pair that touches.

#include "carom/toi/sweep.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/world_state.hpp"

namespace carom::world {

/// The time at which a pair may meet next. \param state of the world, with accelerations set
/// \param index of the pair \param time in this step from which to look; both bodies' states are
/// asked for at that time, and the manifold is that of this time if it is said to be
/// \param end end of the step [s]
/// \return time in this step; infinite if they do not meet [s] \ingroup world
Real nextContact(WorldState& state, Index index, Real time, Real end);

/// The motion of a shape of a body from now on. \param body whose \param now its state
/// \param shape one of its shapes \return motion, its time beginning now \ingroup world
Sweep sweepOf(const BodySlot& body, const BodyState& now, const ShapeSlot& shape);

}  // namespace carom::world
