#pragma once
// Does a block on a slope rest, slide or tip, and does a ball roll or slip?
//
// Method: friction can hold a block up to tan(angle) = mu; its weight stands above its base up to
// tan(angle) = width/height. A ball needs the friction k/(1 + k) sin(angle) of its weight to roll,
// with I = k m R^2; up to tan(angle) = mu (1 + 1/k) it gets that.
// Why here: one contact point at the centre of the base would let the block slide but never tip,
// and one at its lowest corner would let it tip at once.
// Source: case book I8 and I8b.
// Not handled: a block that tips and slides at once; the acceleration given is about an edge that
// holds.

#include "carom/core/real.hpp"
#include "carom/impulse/slide_block.hpp"

namespace carom {

/// What a block on a slope does. \ingroup impulse
enum class BlockFate {
  rests,   ///< friction holds it, and it stands
  slides,  ///< friction does not hold it, and it stands
  tips     ///< it turns about its lower edge, on which friction holds it
};

/// What a block on a slope does, and how. \ingroup impulse
struct BlockOnSlope {
  BlockFate fate = BlockFate::rests;  ///< what it does
  Real acceleration = 0;              ///< downhill, if it slides [m/s^2]
  Real angularAcceleration = 0;       ///< about the lower edge, if it tips [rad/s^2]
};

/// What a block does that is put on a slope.
/// \param width of its base, down the slope, positive [m]
/// \param height positive [m]
/// \param slope on which it is put
/// \return rests, slides or tips; where it would both slide and tip, slides
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
BlockOnSlope blockOnSlope(Real width, Real height, const Slope& slope);

/// What a ball on a slope does. \ingroup impulse
struct BallOnSlope {
  bool slips = false;           ///< whether it slips as it rolls
  Real acceleration = 0;        ///< downhill [m/s^2]
  Real frictionOverWeight = 0;  ///< friction uphill, in parts of its weight [1]
};

/// What a ball, a cylinder or a hoop does that is put on a slope.
/// \param gyration k in I = k m R^2: 2/5 for a solid ball, 2/3 hollow, 1/2 for a cylinder, 1 for a
/// hoop; positive [1]
/// \param slope on which it is put
/// \return whether it slips, and how it accelerates
/// \throws InvalidInput if a number is not finite, or out of the range named here
/// \ingroup impulse
BallOnSlope ballOnSlope(Real gyration, const Slope& slope);

}  // namespace carom
