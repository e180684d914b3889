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
  std::vector<std::int32_t> colors;
  std::set<std::pair<std::int32_t, std::int32_t>> taken;
  for (const ColorEdge& edge : edges) {
    std::int32_t color = 0;
    while (taken.contains({edge.a, color}) || taken.contains({edge.b, color})) ++color;
    for (const std::int32_t body : {edge.a, edge.b}) {
      taken.insert({body, color});
    }
    colors.push_back(color);
  }
  return colors;
}

}  // namespace carom
