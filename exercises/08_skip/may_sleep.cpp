// Exercise 08.may_sleep: is it at rest, or does it only move slowly?
// Check it with: ./course check 08.may_sleep

#include "carom/world/may_sleep.hpp"

#include "carom/core/todo.hpp"

namespace carom::world {

bool maySleep(const RestWatch& watch, const RestLimits& limits) {
  // watch has firstWay, secondWay and speed; limits has speed, distance and noise.
  return todo<bool>("maySleep");
}

}  // namespace carom::world
