#include "carom/world/wake.hpp"

#include <vector>

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  if (movable[first] == 0) return;
  std::vector<std::uint8_t> seen(movable.size(), 0);
  std::vector<std::int32_t> open = {first};
  seen[first] = 1;
  while (!open.empty()) {
    const std::int32_t body = open.back();
    open.pop_back();
    asleep[body] = 0;
    for (const IndexPair& contact : contacts) {
      if (contact.first != body && contact.second != body) continue;
      const std::int32_t other = contact.first == body ? contact.second : contact.first;
      if (seen[other] != 0 || movable[other] == 0) continue;
      seen[other] = 1;
      open.push_back(other);
    }
  }
}

}  // namespace carom::world
