// Exercise 08.find_islands: which bodies have to be stepped together
// Check it with: ./course check 08.find_islands

#include "carom/world/find_islands.hpp"

#include <algorithm>
#include <vector>

#include "carom/core/todo.hpp"

namespace carom::world {

void findIslands(std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
                 std::span<std::int32_t> island) {
  // movable[i] is 0 for a body that nothing moves. Its entry in island becomes kNone.
  // Every other body gets the smallest number in its island.
  return todo<void>("findIslands");
}

}  // namespace carom::world
