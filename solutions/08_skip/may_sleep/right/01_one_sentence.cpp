#include "carom/world/may_sleep.hpp"

namespace carom::world {

bool maySleep(const RestWatch& watch, const RestLimits& limits) {
  const auto within = [&](Real way) { return watch.firstWay <= way && watch.secondWay <= way; };
  const Real all = watch.firstWay + watch.secondWay;
  const bool slow = watch.speed <= limits.speed && all <= limits.distance;
  const bool rounding = all <= limits.noise / 1'000'000;
  const bool trembles = within(limits.noise) && watch.secondWay <= 1.1 * watch.firstWay;
  const bool diesOut = 2 * watch.secondWay <= watch.firstWay;
  return slow && (rounding || trembles || diesOut);
}

}  // namespace carom::world
