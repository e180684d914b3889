#pragma once
// How bouncy must a ball be to come back to a given height?
//
// A ball that falls from rest through h0 arrives with the speed sqrt(2 g h0); to rise to h1 it must
// leave the floor with sqrt(2 g h1). The coefficient of restitution is the second divided by the
// first, so gravity drops out. Not handled: drag, and spin, which both take energy that this does
// not count.

#include "carom/core/real.hpp"

namespace carom {

/// The coefficient of restitution e with which a ball, dropped from rest, comes back to a given
/// height: speed after the bounce divided by speed before it.
/// \param dropHeight from which the lowest point of the ball falls [m], > 0
/// \param returnHeight to which it comes back [m], from 0 to dropHeight
/// \return e, from 0 to 1 [1]
/// \throws InvalidInput when a height is not finite or not in its range; a ball cannot come back
/// higher than it was dropped, because a bounce adds no energy
/// \ingroup core
Real restitutionForHeight(Real dropHeight, Real returnHeight);

}  // namespace carom
