#pragma once
// Who is who in a world?
//
// Bodies and shapes are named by ids of different types, so that one cannot be taken for the other.
// An id of something that was removed is found out by its generation (core/ids.hpp).
// Not handled: ids of another world; whoever keeps two worlds keeps their ids apart.

#include "carom/core/ids.hpp"

/// \defgroup world The world: chapters 8 and 10
/// Bodies that move, touch, sleep and wake, one step at a time.

namespace carom::world {

/// Names a body. \ingroup world
using BodyId = Id<struct BodyTag>;
/// Names one shape of a body. \ingroup world
using ShapeId = Id<struct ShapeTag>;

}  // namespace carom::world
