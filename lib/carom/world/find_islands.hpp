#pragma once
// Which bodies have to be stepped together?
//
// Method: union and find. Each body begins as an island of its own; each contact joins the islands
// of its two bodies; the island is named by its smallest number. Who asks for a name walks to the
// top, and shortens the way for the next one.
// Why not walk from body to body: that needs a list of neighbours per body and a stack; here one
// number per body is all there is.
// The one trap: a body that nothing moves conducts nothing. Two towers on one floor are two
// islands.
// Source: Galler and Fischer 1964; halving of paths: van der Weide 1980.
// Not handled: islands that come apart slowly; whoever keeps islands asks again when a contact
// ends.

#include <cstdint>
#include <span>

#include "carom/broadphase/index_pair.hpp"

namespace carom::world {

/// The islands of a set of bodies.
/// \param contacts pairs of bodies, numbers into movable
/// \param movable 1 for a body that an impulse moves, 0 for one that nothing moves
/// \param island receives per body the smallest number in its island; kNone for bodies that nothing
/// moves; as long as movable
/// \ingroup world
void findIslands(std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
                 std::span<std::int32_t> island);

}  // namespace carom::world
