#include "carom/impulse/slide_block.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"

namespace carom {

namespace {

// The acceleration downhill of a block that slides downhill, or uphill.
Real acceleration(const Slope& slope, bool downhill) {
  const auto [sin, cos] = sineCosine(slope.angle);
  return slope.gravity * (downhill ? sin - slope.friction * cos : sin + slope.friction * cos);
}

void requireFinite(const SlidingBlock& block) {
  carom::requireFinite(block.position, "position");
  carom::requireFinite(block.velocity, "velocity");
}

SlidingBlock fallen(const SlidingBlock& block, Real a, Real t) {
  return {block.position + (block.velocity + a * t / 2) * t, block.velocity + a * t};
}

}  // namespace

void requireUsable(const Slope& slope) {
  if (!(slope.angle >= 0 && slope.angle <= std::numbers::pi / 2)) {
    reject("angle", toText(slope.angle), "must be from 0 to a quarter turn");
  }
  requireNonNegative(slope.friction, "friction");
  requirePositive(slope.gravity, "gravity");
}

Real timeToStop(const SlidingBlock& block, const Slope& slope) {
  requireFinite(block);
  requireUsable(slope);
  if (block.velocity == 0) return 0;
  const Real a = acceleration(slope, block.velocity > 0);
  const Real time = -block.velocity / a;
  return time >= 0 ? time : std::numeric_limits<Real>::infinity();
}

SlidingBlock slideBlock(const SlidingBlock& block, const Slope& slope, Real time) {
  requireNonNegative(time, "time");
  const Real stop = timeToStop(block, slope);
  if (time < stop) return fallen(block, acceleration(slope, block.velocity > 0), time);
  // At rest, exactly; v/2 is the mean speed on the way there.
  const SlidingBlock resting{block.position + (stop > 0 ? block.velocity / 2 * stop : 0), 0};
  const Real onwards = acceleration(slope, true);
  return onwards > 0 ? fallen(resting, onwards, time - stop) : resting;
}

}  // namespace carom
