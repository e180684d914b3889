#pragma once
// How is one island stepped?
//
// Method: by events. The bodies of the island move on parabolas, those that touch by the
// accelerations of their phase, until the first of them meets something or stops slipping. Only the
// bodies that this concerns are brought to that moment; impacts are resolved there, their contacts
// are solved for what is left of the step, and only their pairs are searched again. At the end all
// are at the end. A pair of balls in a gas of thousands costs a pair of balls.
// A body that turns about an edge or a corner is an event sixteen times a step: the forces on it
// change as it turns, and are found anew.
// An island with more closed contacts than the settings allow is stepped at once instead: what
// would meet within the step meets at its start, and its points are held apart until they can
// touch.
// An island in which a step has changed nothing, not even a last bit, is not stepped again until
// something is done to it: every further step would compute the same.
// Source: event-driven molecular dynamics, Alder and Wainwright 1959; own clocks: Lubachevsky 1991;
// at once: speculative contacts, Firth 2011, after impacts as in Moreau's time stepping.
// Not handled: islands that meet each other within the step are one island (update_contacts.hpp).

#include "carom/world/world_state.hpp"

namespace carom::world {

/// How an island came through.
/// \ingroup world
struct IslandRun {
  bool byEvents = false;  ///< false: stepped at once
  bool isPile = false;    ///< stepped by soft steps
  int events = 0;         ///< things that happened after the start
};

/// Steps an island. \param state of the world, the island's manifolds made at the start
/// \param island that is awake, its bodies all at the time `start`
/// \param start in this step [s] \param end in this step, later [s]
/// \return how it went \ingroup world
IslandRun advanceIsland(WorldState& state, Index island, Real start, Real end);

/// Steps all islands that are awake; the piles among them go together.
/// \param state of the world, manifolds made at the start of the step \param dt its length [s]
/// \ingroup world
void advanceIslands(WorldState& state, Real dt);

}  // namespace carom::world
