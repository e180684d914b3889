#pragma once
// What happens at the moment when bodies have met?
//
// Method: all closed points of the set act together. Where nothing bounces, the solver takes away
// the approach of all of them, with friction, as it would over a step of no length. What bounces
// goes through rounds, so that a blow travels through a chain (simultaneous_impacts.hpp); the
// points of one pair are one contact there, at the centre of their pressure. A contact alone
// follows Newton's and Coulomb's laws where these make no energy, else one that never does
// (bounded_impact.hpp).
// A bounce that would be over within the shortest time of the settings is none: the contact is then
// a resting one, and a ball that bounces lower and lower comes to rest in finite time.
// Source: chapter 5.
// Not handled: how long an impact takes.

#include <span>

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Lets the closed points of a set of bodies act. \param state of the world
/// \param bodies dynamic ones, all at the time of the manifolds; their velocities are changed
/// \param pairs with fresh manifolds \param time in this step, for the events [s]
/// \param bounce false: nothing bounces
/// \return whether there was an impact \ingroup world
bool resolveImpacts(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                    Real time, bool bounce);

/// Takes away the approach of all points that would meet within the step, as if they met at its
/// start: for sets in which no events are looked for. \param state of the world
/// \param bodies dynamic ones; their velocities are changed \param pairs with fresh manifolds
/// \param time in this step, for the events [s] \param dt what is left of the step [s]
/// \ingroup world
void resolveAtOnce(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                   Real time, Real dt);

}  // namespace carom::world
