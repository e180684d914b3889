#include "carom/world/may_sleep.hpp"

namespace carom::world {

bool maySleep(const RestWatch& watch, const RestLimits& limits) {
  if (watch.speed > limits.speed) return false;
  if (watch.firstWay + watch.secondWay > limits.distance) return false;
  const bool tiny = watch.firstWay <= limits.noise && watch.secondWay <= limits.noise;
  return watch.secondWay <= (tiny ? 1.1 : 0.5) * watch.firstWay;
}

}  // namespace carom::world
