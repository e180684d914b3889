#pragma once
// Somebody pushes a sleeping body. Who else has to wake?
//
// Method: the body itself, and whoever touches one that is awake, again and again until nobody is
// added. Bodies that nothing moves are not woken and pass nothing on: a push on one tower of a city
// must not wake all that stand on the same ground.
// Why all of them and not the neighbours alone: the box at the bottom is held down by the one at
// the top, and what is asleep does not notice that its neighbour has gone.
// Source: islands that sleep as a whole: Open Dynamics Engine, Box2D.
// Not handled: bodies near by that do not touch; they wake when they are touched.

#include <cstdint>
#include <span>

#include "carom/broadphase/index_pair.hpp"

namespace carom::world {

/// Wakes a body and all that it is joined with by contacts.
/// \param first the body that was pushed
/// \param contacts pairs of bodies, numbers into movable
/// \param movable 1 for a body that an impulse moves, 0 for one that nothing moves
/// \param asleep 1 for a body that sleeps; receives 0 for all that wake; as long as movable
/// \ingroup world
void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep);

}  // namespace carom::world
