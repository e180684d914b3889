#include "carom/world/wake.hpp"

#include <vector>

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  if (movable[first] == 0) return;
  std::vector<std::uint8_t> woken(movable.size(), 0);
  woken[first] = 1;
  asleep[first] = 0;
  for (const auto& [a, b] : contacts) {
    if (movable[a] == 0 || movable[b] == 0 || woken[a] == woken[b]) continue;
    woken[a] = woken[b] = 1;
    asleep[a] = asleep[b] = 0;
  }
}

}  // namespace carom::world
