#include "carom/world/find_islands.hpp"

#include <algorithm>
#include <vector>

namespace carom::world {

std::int32_t topOf(std::span<const std::int32_t> island, std::int32_t body) {
  while (island[body] != body) body = island[body];
  return body;
}

void findIslands(std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
                 std::span<std::int32_t> island) {
  const auto count = static_cast<std::int32_t>(movable.size());
  std::vector<std::uint8_t> touches(movable.size(), 0);
  for (std::int32_t i = 0; i < count; ++i) island[i] = i;
  for (const IndexPair& contact : contacts) {
    if (movable[contact.first] == 0 || movable[contact.second] == 0) continue;
    const std::int32_t a = topOf(island, contact.first), b = topOf(island, contact.second);
    island[std::max(a, b)] = std::min(a, b);
    touches[contact.first] = touches[contact.second] = 1;
  }
  for (std::int32_t i = 0; i < count; ++i) island[i] = touches[i] == 0 ? kNone : topOf(island, i);
}

}  // namespace carom::world
