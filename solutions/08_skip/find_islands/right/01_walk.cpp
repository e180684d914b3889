#include "carom/world/find_islands.hpp"

#include <algorithm>
#include <vector>

namespace carom::world {

void findIslands(std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
                 std::span<std::int32_t> island) {
  const auto count = static_cast<std::int32_t>(movable.size());
  std::vector<std::vector<std::int32_t>> neighbours(movable.size());
  for (const IndexPair& contact : contacts) {
    neighbours[contact.first].push_back(contact.second);
    neighbours[contact.second].push_back(contact.first);
  }
  std::fill(island.begin(), island.end(), kNone);
  for (std::int32_t first = 0; first < count; ++first) {
    if (movable[first] == 0 || island[first] != kNone) continue;
    std::vector<std::int32_t> open = {first};
    island[first] = first;
    while (!open.empty()) {
      const std::int32_t body = open.back();
      open.pop_back();
      for (const std::int32_t other : neighbours[body]) {
        if (movable[other] == 0 || island[other] != kNone) continue;
        island[other] = first;
        open.push_back(other);
      }
    }
  }
}

}  // namespace carom::world
