#pragma once
// Who is near whom, and where do they touch?
//
// Method: each awake body says which boxes its shapes can be in during the step: where they are,
// with room on all sides for the way that they can go. On all sides, and not ahead only, because an
// impact can turn the way round. What may be struck by something faster gets the room of that, up
// to a few neighbours, lest it meets a third body unseen. The broad phase answers with pairs that
// began and ended. A pair whose boxes meet gets a manifold that reaches as far as the two can come
// nearer in the step; it holds its bodies together as an island, and wakes a body that slept.
// The forces of the last step are handed on to the points that have the same names or places.
// Why no manifold for boxes that do not meet: no point can touch in this step. Nor can one of bodies
// that pass each other, as far as each of them may be turned aside.
// Not handled: what the manifolds are for (contact_phase.hpp).

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Finds the pairs that began or ended. \param state of the world \param dt length of the step [s]
/// \ingroup world
void updatePairs(WorldState& state, Real dt);

/// Makes the manifolds of all pairs that are awake, joins and releases pairs and wakes bodies.
/// \param state of the world \param dt length of the step [s] \ingroup world
void updateManifolds(WorldState& state, Real dt);

/// Makes the manifold of a pair at a time of this step. \param state of the world
/// \param index of the pair \param time in this step [s]
/// \param rest how much of the step is left [s] \ingroup world
void makeManifold(WorldState& state, Index index, Real time, Real rest);

/// The same, also where there is one of that time: something has moved since. \param state of the
/// world \param index of the pair \param time in this step [s] \param rest as above [s]
/// \ingroup world
void remakeManifold(WorldState& state, Index index, Real time, Real rest);

/// The gap at which approaching points of a pair have met: that of the settings, and what rounding
/// makes of coordinates. \param state of the world \param pair which \return [m] \ingroup world
Real touchGap(const WorldState& state, const PairSlot& pair);

/// Whether a point of a pair's manifold is closed: touches, or carried and is hardly off.
/// \param state of the world \param pair which \param point its number \return true if closed
/// \ingroup world
bool isClosed(const WorldState& state, const PairSlot& pair, int point);

/// The tight box of a shape. \param shape any \param pose world from shape \return box [m, world]
/// \ingroup world
Aabb<3> boundsOfShape(const ShapeSlot& shape, const Pose& pose);

/// Takes up where a body may be, so that pairs are found. \param state of the world
/// \param body any \param dt length of the step [s] \ingroup world
void moveBoxes(WorldState& state, Index body, Real dt);

/// Gives the lists that a step writes anew room for a number of bodies and pairs, so that they ask
/// for no memory later. \param state of the world \param bodies how many there may be
/// \param pairs how many there may be \ingroup world
void makeRoomForLists(WorldState& state, std::size_t bodies, std::size_t pairs);

/// Whether two shapes may meet at all. \param state of the world \param a one \param b another
/// \return false if of one body, both not dynamic, or kept apart by their filters \ingroup world
bool mayMeet(const WorldState& state, Index a, Index b);

/// Ends a pair that the broad phase has given up. \param state of the world \param pair its slot
/// \ingroup world
void endPair(WorldState& state, Index pair);

/// The event of a pair that begins or ends to touch. \param state of the world \param pair which
/// \return its ids \ingroup world
ContactEvent eventOf(const WorldState& state, const PairSlot& pair);

}  // namespace carom::world
