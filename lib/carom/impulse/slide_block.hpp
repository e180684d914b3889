#pragma once
// Where is a block that slides on a slope, and when does it stop?
//
// Method: between two events the acceleration is constant, so the motion is a parabola; the only
// event is that the block stops. The time of that is computed, not stepped over, so the position is
// right to rounding for any step. After it the block stays if friction can hold it, |tan| <= mu,
// and else slides down.
// Why not step and clamp: friction is as large as it is until the speed is zero, and then smaller
// at once. A step that reaches over that moment is wrong by up to h v/2, and without a clamp it
// pushes the block back and forth for ever.
// Source: the change from slip to stick as an event, as in Painlevé's time; case book I6 and I8.
// Not handled: blocks that tip over (block_on_slope.hpp), motion across the slope.

#include "carom/core/real.hpp"

namespace carom {

/// A plane on which something slides. \ingroup impulse
struct Slope {
  Real angle = 0;       ///< against the level, from 0 to a quarter turn [rad]
  Real friction = 0;    ///< mu, zero or positive [1]
  Real gravity = 9.81;  ///< positive [m/s^2]
};

/// How a block moves along the slope. \ingroup impulse
struct SlidingBlock {
  Real position = 0;  ///< downhill [m]
  Real velocity = 0;  ///< downhill positive [m/s]
};

/// Where the block is after a while.
/// \param block at the start \param slope on which it lies \param time zero or positive [s]
/// \return the block then; its velocity is exactly zero once it rests
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
SlidingBlock slideBlock(const SlidingBlock& block, const Slope& slope, Real time);

/// When the block first stops.
/// \param block at the start \param slope on which it lies
/// \return time from the start; 0 if it does not move, infinite if it never stops [s]
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
Real timeToStop(const SlidingBlock& block, const Slope& slope);

/// Refuses a slope that cannot be worked with. \param slope any slope
/// \throws InvalidInput if a number is not finite, or out of the range named in Slope
/// \ingroup impulse
void requireUsable(const Slope& slope);

}  // namespace carom
