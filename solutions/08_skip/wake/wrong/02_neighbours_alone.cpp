#include "carom/world/wake.hpp"

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  if (movable[first] == 0) return;
  asleep[first] = 0;
  for (const auto& [a, b] : contacts) {
    if (a == first && movable[b] != 0) asleep[b] = 0;
    if (b == first && movable[a] != 0) asleep[a] = 0;
  }
}

}  // namespace carom::world
