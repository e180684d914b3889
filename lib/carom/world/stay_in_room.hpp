#pragma once
// What of a body that is thrown farther than anybody looked, or pressed through a wall?
//
// Pairs are found at the start of a step, from how far each body goes and how far others can throw
// it (update_contacts.hpp). Several blows in one step, or one by something far heavier, may throw a
// small body farther. Beside others that shows as overlap, and is taken away later; a wall it would
// pass for good.
// Method: before a body makes its last way of the step, the trees are asked whether anything that
// cannot be moved is on it and is no pair of the body. If so, the body stops where its box ends,
// and loses the rest of its time: it keeps velocity and energy, and goes on in the next step.
// A wall is also passed where contacts are not followed: by what turns by radians in a step that is
// taken at once, by what others press into a sheet, which holds nobody from behind, and where more
// happens in a step than anybody goes after. So after a step the middle of each shape must be on the
// side of the wall on which it was before: it is what a ball of no size would be, which strikes there
// and does not bounce. Its body pays for being lifted with the speed along that way.
// Why not find pairs again: it is rare, and islands would have to be joined in the middle of a step.
// Source: bodies that lose time at impacts: Catto, Continuous collision, GDC 2013.
// Not handled: bodies that can be moved; what they overlap is taken away later.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// A part of a step. \ingroup world
struct StepSpan {
  Real start = 0;  ///< [s]
  Real end = 0;    ///< [s]
};

/// Moves a body to the border of its box, if it would leave it and a wall stands there, and sets its
/// clock to the end. \param state of the world \param index of the body, its accelerations set
/// \param end of the step [s] \ingroup world
void stayInRoom(WorldState& state, Index index, Real end);

/// Writes down where an island's bodies are. \param state of the world
/// \param bodies of the island \ingroup world
void rememberStarts(WorldState& state, std::span<const Index> bodies);

/// Puts bodies back of which the middle of a shape has gone behind a wall since they were written
/// down, and takes the speed from them with which they go on there.
/// \param state of the world, the island at the end \param bodies of the island, as written down
/// \param pairs of the island, those of walls at least \param span from when to when [s]
/// \ingroup world
void holdMiddles(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                 const StepSpan& span);

}  // namespace carom::world
