#include "carom/solver/color_graph.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

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
  // has[body][c]: a contact of the body has colour c. What cannot be moved never has one.
  std::vector<std::vector<bool>> has(static_cast<std::size_t>(movable));
  for (const ColorEdge& edge : edges) {
    const auto taken = [&](std::int32_t body, std::size_t color) {
      if (body >= movable) return false;
      const std::vector<bool>& of = has[static_cast<std::size_t>(body)];
      return color < of.size() && of[color];
    };
    std::size_t color = 0;
    while (taken(edge.a, color) || taken(edge.b, color)) ++color;
    const auto note = [&](std::int32_t body) {
      if (body >= movable) return;
      std::vector<bool>& of = has[static_cast<std::size_t>(body)];
      of.resize(std::max(of.size(), color + 1), false);
      of[color] = true;
    };
    note(edge.a);
    note(edge.b);
    colors.push_back(static_cast<std::int32_t>(color));
  }
  return colors;
}

}  // namespace carom
