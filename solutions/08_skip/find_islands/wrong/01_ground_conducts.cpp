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
  for (std::int32_t i = 0; i < count; ++i) island[i] = i;
  for (const IndexPair& contact : contacts) {
    const std::int32_t a = topOf(island, contact.first), b = topOf(island, contact.second);
    island[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::int32_t> smallest(movable.size(), count);
  for (std::int32_t i = count; i-- > 0;) {
    if (movable[i] != 0) smallest[topOf(island, i)] = i;
  }
  std::vector<std::int32_t> named(movable.size(), kNone);
  for (std::int32_t i = 0; i < count; ++i) {
    if (movable[i] != 0) named[i] = smallest[topOf(island, i)];
  }
  std::copy(named.begin(), named.end(), island.begin());
}

}  // namespace carom::world
