#include "carom/world/wake.hpp"

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  if (movable[first] == 0) return;
  asleep[first] = 0;
  for (bool woken = true; woken;) {
    woken = false;
    for (const IndexPair& contact : contacts) {
      const std::int32_t a = contact.first, b = contact.second;
      if (movable[a] == 0 || movable[b] == 0 || asleep[a] == asleep[b]) continue;
      asleep[a] = asleep[b] = 0;
      woken = true;
    }
  }
}

}  // namespace carom::world
