#include "carom/solver/graph_colors.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace carom {

int GraphColors::color(std::span<const ColorEdge> edges, std::int32_t movable,
                       std::vector<std::int32_t>& colors) {
  constexpr std::int32_t kBits = 64;
  colors.assign(edges.size(), 0);
  int count = 0;
  for (const bool between : {true, false}) {
    // Edges between two bodies that move, then those with what stands still, in new colours.
    const int first = count;
    taken_.assign(static_cast<std::size_t>(movable), 0);
    next_.assign(static_cast<std::size_t>(movable), kBits);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto [a, b] = edges[e];
      const bool movesA = a < movable, movesB = b < movable;
      if ((movesA && movesB) != between) continue;
      std::uint64_t mask = 0;
      std::int32_t after = kBits;
      for (const std::int32_t body : {a, b}) {
        if (body >= movable) continue;
        mask |= taken_[static_cast<std::size_t>(body)];
        after = std::max(after, next_[static_cast<std::size_t>(body)]);
      }
      const int free = std::countr_one(mask);
      const std::int32_t color = free < kBits ? free : after;
      for (const std::int32_t body : {a, b}) {
        if (body >= movable) continue;
        if (free < kBits) {
          taken_[static_cast<std::size_t>(body)] |= std::uint64_t(1) << free;
        } else {
          next_[static_cast<std::size_t>(body)] = color + 1;
        }
      }
      colors[e] = first + color;
      count = std::max(count, first + color + 1);
    }
  }
  return count;
}

}  // namespace carom
