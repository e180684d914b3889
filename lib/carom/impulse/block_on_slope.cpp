#include "carom/impulse/block_on_slope.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"

namespace carom {

BlockOnSlope blockOnSlope(Real width, Real height, const Slope& slope) {
  requirePositive(width, "width");
  requirePositive(height, "height");
  requireUsable(slope);
  const auto [sin, cos] = sineCosine(slope.angle);
  BlockOnSlope result;
  if (sin > slope.friction * cos) {
    result.fate = BlockFate::slides;
    result.acceleration = slope.gravity * (sin - slope.friction * cos);
  } else if (height * sin > width * cos) {
    result.fate = BlockFate::tips;
    // Torque of the weight about the edge, over the moment (b^2 + h^2)/3 about it, per kilogram.
    result.angularAcceleration =
        slope.gravity * (height * sin - width * cos) / 2 / ((width * width + height * height) / 3);
  }
  return result;
}

BallOnSlope ballOnSlope(Real gyration, const Slope& slope) {
  requirePositive(gyration, "gyration");
  requireUsable(slope);
  const auto [sin, cos] = sineCosine(slope.angle);
  const Real needed = sin * gyration / (1 + gyration), most = slope.friction * cos;
  const bool slips = needed > most;
  const Real friction = slips ? most : needed;
  return {slips, slope.gravity * (sin - friction), friction};
}

}  // namespace carom
