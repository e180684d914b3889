#pragma once
// How is a world moved on so that the error stays below a tolerance?
//
// | stage             | reads                            | writes                                |
// | long step         | where bodies can get to          | pairs, manifolds, islands             |
// | islands, each:    | its bodies and pairs             | nothing yet                           |
// |   tries           | the same time in 1, 2, 3 … steps | ends; what was before is put back     |
// |   answer          | what the tries tend to           | its bodies, or a shorter time to try  |
// | free bodies       | their state                      | their state at the end, exactly       |
// | report, sleep     | as in a step                     | events, who is awake                  |
//
// Method: long steps search for pairs once, as long as that pays: each body's box holds all it can
// reach. Within, each island chooses steps of its own. It goes the same time once in one step, then
// in two, three and more, each by events (advance_island.hpp). What these ends tend to for steps of
// no length is an answer of high order as long as contacts neither begin nor end on the way, so
// smooth motion costs little however small the tolerance. That asks for steps whose error is a
// power of their length: each ends where the contacts let it (project_velocities.hpp), and a body
// whose inertia turns with it is solved twice (contact_phase.hpp). How many tries there are, and
// how long the next time is, is what costs least for the time that it covers (step_controller.hpp).
// Where something happens on the way, the ends of one and two steps must agree as they are, and the
// time is cut until they do. What nothing holds, or only bounces, is exact and goes in one. The
// error of a velocity counts for the time that is left, and for a second at least.
// A body that leaves its box could meet what its island does not know: then the long step is taken
// back and cut. Bounces that rise less than a quarter of the tolerance are none: so bounces that
// follow each other ever faster end in rest.
// Source: extrapolation of a constrained motion: Lubich, Mechanics of Structures and Machines 19,
// 1991 (MEXX); choice of order: Deuflhard 1983; Hairer, Nørsett and Wanner I, II.9; error per time:
// the same, II.4.
// Not handled: motion in which errors grow by themselves (chaos), beyond the safety of the tries;
// islands with more closed contacts than are taken by events converge slowly, and piles are stepped
// as ever (settings.hpp).

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Moves everything on with an error below the tolerance. \param state of the world
/// \param duration positive [s] \param tolerance of places at the end, positive [m]
/// \ingroup world
void advanceWorld(WorldState& state, Real duration, Real tolerance);

}  // namespace carom::world
