#include "carom/world/may_sleep.hpp"

namespace carom::world {

bool maySleep(const RestWatch& watch, const RestLimits& limits) {
  return watch.speed <= limits.speed && watch.firstWay + watch.secondWay <= limits.distance;
}

}  // namespace carom::world
