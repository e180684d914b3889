#include "carom/world/wake.hpp"

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  if (movable[first] == 0) return;
  for (std::size_t i = 0; i < asleep.size(); ++i) {
    if (movable[i] != 0) asleep[i] = 0;
  }
}

}  // namespace carom::world
