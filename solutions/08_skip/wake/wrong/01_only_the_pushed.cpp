#include "carom/world/wake.hpp"

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  if (movable[first] != 0) asleep[first] = 0;
}

}  // namespace carom::world
