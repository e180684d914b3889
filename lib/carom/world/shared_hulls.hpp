#pragma once
// Has this hull been added before?
//
// Method: what shapes look like never changes, so that bodies with equal hulls share one. A world
// knows its hulls by a number made of their corners; of those that have the same number, all parts
// are compared, bit by bit.
// Why: a heap of a thousand equal stones would otherwise read a thousand copies of a hull in each
// step, more than the caches of a processor hold.
// Not handled: hulls that differ by a rounding, or by the order of their corners, are two.

#include <memory>

#include "carom/detection/convex_hull.hpp"
#include "carom/world/world_state.hpp"

namespace carom::world {

/// The data of a hull: those of an equal one that a shape of this world has, or new ones.
/// \param state of the world \param hull usable \return what shapes share \ingroup world
std::shared_ptr<const ShapeData> sharedHull(WorldState& state, const ConvexHull& hull);

}  // namespace carom::world
