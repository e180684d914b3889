#include "carom/world/find_islands.hpp"

#include <algorithm>

namespace carom::world {

void findIslands(std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
                 std::span<std::int32_t> island) {
  for (std::size_t i = 0; i < island.size(); ++i) {
    island[i] = movable[i] != 0 ? static_cast<std::int32_t>(i) : kNone;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : contacts) {
      if (movable[a] == 0 || movable[b] == 0 || island[a] == island[b]) continue;
      island[a] = island[b] = std::min(island[a], island[b]);
      changed = true;
    }
  }
}

}  // namespace carom::world
