#include "carom/solver/graph_colors.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/reserve_ahead.hpp"
#include "carom/core/variant.hpp"

namespace carom {

namespace {

// The same by the plain function, with edges between two bodies that move first.
int plainly(std::span<const ColorEdge> edges, std::int32_t movable,
            std::vector<std::int32_t>& colors) {
  colors.assign(edges.size(), 0);
  int count = 0;
  for (const bool between : {true, false}) {
    std::vector<ColorEdge> some;
    std::vector<std::size_t> which;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if ((edges[e].a < movable && edges[e].b < movable) != between) continue;
      some.push_back(edges[e]);
      which.push_back(e);
    }
    const std::vector<std::int32_t> own = colorGraph(some, movable);
    if (own.size() != some.size()) {
      reject("colours", std::to_string(own.size()), "must be as many as contacts");
    }
    const int first = count;
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (own[i] < 0) reject("colour", std::to_string(own[i]), "must not be negative");
      colors[which[i]] = first + own[i];
      count = std::max(count, first + own[i] + 1);
    }
  }
  return count;
}

}  // namespace

int GraphColors::color(std::span<const ColorEdge> edges, std::int32_t movable,
                       std::vector<std::int32_t>& colors) {
  if (takesPlainPath()) return plainly(edges, movable, colors);
  constexpr std::int32_t kBits = 64;
  const auto bodies = static_cast<std::size_t>(movable);
  reserveAhead(colors, edges.size());
  reserveAhead(taken_, bodies);
  reserveAhead(next_, bodies);
  colors.assign(edges.size(), 0);
  int count = 0;
  for (const bool between : {true, false}) {
    // Edges between two bodies that move, then those with what stands still, in new colours.
    const int first = count;
    taken_.assign(bodies, 0);
    next_.assign(bodies, kBits);
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
