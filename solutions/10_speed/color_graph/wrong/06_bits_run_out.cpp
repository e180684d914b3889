#include "carom/solver/color_graph.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "carom/core/checks.hpp"

namespace carom {

std::vector<std::int32_t> colorGraph(std::span<const ColorEdge> edges, std::int32_t movable) {
  if (movable < 0) reject("movable", std::to_string(movable), "must not be negative");
  for (const ColorEdge& edge : edges) {
    const std::int32_t least = std::min(edge.a, edge.b);
    if (least < 0) reject("body", std::to_string(least), "must not be negative");
    if (edge.a == edge.b && edge.a < movable) {
      reject("contact", std::to_string(edge.a) + " with itself", "must join two bodies");
    }
  }
  // A bit for each colour of a body.
  std::vector<std::uint32_t> taken(static_cast<std::size_t>(movable), 0);
  std::vector<std::int32_t> colors;
  for (const ColorEdge& edge : edges) {
    std::uint32_t mask = 0;
    for (const std::int32_t body : {edge.a, edge.b}) {
      if (body < movable) mask |= taken[static_cast<std::size_t>(body)];
    }
    std::int32_t color = 0;
    while (color < 31 && ((mask >> color) & 1u) != 0) ++color;
    for (const std::int32_t body : {edge.a, edge.b}) {
      if (body < movable) taken[static_cast<std::size_t>(body)] |= std::uint32_t(1) << color;
    }
    colors.push_back(color);
  }
  return colors;
}

}  // namespace carom
