// Exercise 08.find_islands: which bodies have to be stepped together
// Check it with: ./course check 08.find_islands

#include "carom/world/find_islands.hpp"

#include <algorithm>
#include <vector>

#include "carom/core/todo.hpp"

namespace carom::world {

void findIslands(std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
                 std::span<std::int32_t> island) {
  //# solution
  const auto count = static_cast<std::int32_t>(movable.size());
  for (std::int32_t i = 0; i < count; ++i) island[i] = i;
  const auto topOf = [&](std::int32_t body) {
    while (island[body] != body) body = island[body] = island[island[body]];
    return body;
  };
  for (const IndexPair& contact : contacts) {
    if (movable[contact.first] == 0 || movable[contact.second] == 0) continue;
    const std::int32_t a = topOf(contact.first), b = topOf(contact.second);
    island[std::max(a, b)] = std::min(a, b);
  }
  for (std::int32_t i = 0; i < count; ++i) island[i] = movable[i] == 0 ? kNone : topOf(i);
  //# stub
  // movable[i] is 0 for a body that nothing moves. Its entry in island becomes kNone.
  // Every other body gets the smallest number in its island.
  //#| return todo<void>("findIslands");
  //# end
}

}  // namespace carom::world
