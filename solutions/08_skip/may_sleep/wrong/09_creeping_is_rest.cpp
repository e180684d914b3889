#include "carom/world/may_sleep.hpp"

namespace carom::world {

bool maySleep(const RestWatch& watch, const RestLimits& limits) {
  if (watch.speed > limits.speed) return false;
  if (watch.firstWay + watch.secondWay > limits.distance) return false;
  if (watch.firstWay + watch.secondWay <= 1e-6 * limits.noise) return true;
  return watch.secondWay <= 1.1 * watch.firstWay;
}

}  // namespace carom::world
