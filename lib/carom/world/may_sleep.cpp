#include "carom/world/may_sleep.hpp"

namespace carom::world {

bool maySleep(const RestWatch& watch, const RestLimits& limits) {
  if (watch.speed > limits.speed) return false;
  if (watch.firstWay + watch.secondWay > limits.distance) return false;
  // A thousandth of what solvers leave is not even that: it is rounding, and has no direction.
  constexpr Real kRounding = 1e-3;
  if (watch.firstWay + watch.secondWay <= kRounding * kRounding * limits.noise) return true;
  const bool tiny = watch.firstWay <= limits.noise && watch.secondWay <= limits.noise;
  // What falls over multiplies its way by more than this while it is watched.
  constexpr Real kGrows = 1.1, kDies = 0.5;
  return watch.secondWay <= (tiny ? kGrows : kDies) * watch.firstWay;
}

}  // namespace carom::world
