#pragma once
// How does a body come into a world, and leave it?
//
// Everything is looked at first, and only then is anything changed, so that a body that is refused
// leaves no trace. Compounds are taken apart into their convex parts.

#include "carom/world/world_state.hpp"

namespace carom::world {

/// Refuses a description that no body can be made of. \param state of the world
/// \param description any
/// \throws InvalidInput naming the value and the rule \ingroup world
void requireUsable(const WorldState& state, const BodyDescription& description);

/// Adds a body. \param state of the world; unchanged if the body is refused
/// \param description of it \return its id
/// \throws InvalidInput naming the value and the rule \ingroup world
BodyId addBody(WorldState& state, const BodyDescription& description);

/// Removes a body, and wakes what it touched. \param state of the world \param index of the body
/// \ingroup world
void removeBody(WorldState& state, Index index);

/// A quaternion that is to be a rotation. \param q of norm one within 1e-6 \param name what it is
/// called \return the same with norm one
/// \throws InvalidInput if it is not \ingroup world
Quaternion requireUnit(const Quaternion& q, const char* name);

}  // namespace carom::world
