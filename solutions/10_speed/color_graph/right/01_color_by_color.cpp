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
  // Fill one colour after the other with what still fits into it.
  std::vector<std::int32_t> colors(edges.size(), -1);
  std::size_t left = edges.size();
  for (std::int32_t color = 0; left > 0; ++color) {
    std::set<std::int32_t> busy;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const std::int32_t a = edges[e].a, b = edges[e].b;
      if (colors[e] >= 0 || busy.contains(a) || busy.contains(b)) continue;
      colors[e] = color;
      --left;
      if (a < movable) busy.insert(a);
      if (b < movable) busy.insert(b);
    }
  }
  return colors;
}

}  // namespace carom
