#include "carom/world/find_islands.hpp"

#include <algorithm>

namespace carom::world {

void findIslands(std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
                 std::span<std::int32_t> island) {
  const auto count = static_cast<std::int32_t>(movable.size());
  for (std::int32_t i = 0; i < count; ++i) island[i] = i;
  for (const IndexPair& contact : contacts) {
    if (movable[contact.first] == 0 || movable[contact.second] == 0) continue;
    const std::int32_t a = contact.first, b = contact.second;
    island[a] = island[b] = std::min(island[a], island[b]);
  }
  for (std::int32_t i = 0; i < count; ++i) {
    if (movable[i] == 0) island[i] = kNone;
  }
}

}  // namespace carom::world
