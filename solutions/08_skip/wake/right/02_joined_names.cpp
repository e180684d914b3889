#include "carom/world/wake.hpp"

#include <vector>

namespace carom::world {

void wake(std::int32_t first, std::span<const IndexPair> contacts,
          std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep) {
  if (movable[first] == 0) return;
  std::vector<std::int32_t> name;
  for (std::size_t i = 0; i < movable.size(); ++i) name.push_back(static_cast<std::int32_t>(i));
  for (const auto& [a, b] : contacts) {
    if (movable[a] == 0 || movable[b] == 0) continue;
    const std::int32_t from = name[a], to = name[b];
    for (std::int32_t& one : name) {
      if (one == from) one = to;
    }
  }
  for (std::size_t i = 0; i < movable.size(); ++i) {
    if (movable[i] != 0 && name[i] == name[first]) asleep[i] = 0;
  }
}

}  // namespace carom::world
