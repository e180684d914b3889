// Exercise 08.may_sleep: is it at rest, or does it only move slowly?
// Check it with: ./course check 08.may_sleep

#include "carom/world/may_sleep.hpp"

#include "carom/core/todo.hpp"

namespace carom::world {

bool maySleep(const RestWatch& watch, const RestLimits& limits) {
  //# solution
  const Real way = watch.firstWay + watch.secondWay;
  if (watch.speed > limits.speed || way > limits.distance) return false;
  if (way <= 1e-6 * limits.noise) return true;
  const bool tiny = watch.firstWay <= limits.noise && watch.secondWay <= limits.noise;
  return watch.secondWay <= (tiny ? 1.1 : 0.5) * watch.firstWay;
  //# stub
  // watch has firstWay, secondWay and speed; limits has speed, distance and noise.
  //#| return todo<bool>("maySleep");
  //# end
}

}  // namespace carom::world
