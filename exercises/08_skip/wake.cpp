// Exercise 08.wake: who wakes when a sleeping body is pushed
// Check it with: ./course check 08.wake

#include "carom/world/wake.hpp"

#include <vector>

#include "carom/core/todo.hpp"

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  // asleep[i] is 1 for a body that sleeps: write 0 for each one that wakes.
  // movable[i] is 0 for a body that nothing moves: it is left as it is.
  return todo<void>("wake");
}

}  // namespace carom::world
