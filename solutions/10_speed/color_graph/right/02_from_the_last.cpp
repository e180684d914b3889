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
  // From the last contact to the first, against all that share a body.
  std::vector<std::int32_t> colors(edges.size(), -1);
  const auto meet = [&](const ColorEdge& p, const ColorEdge& q) {
    return ((p.a == q.a || p.a == q.b) && p.a < movable) ||
           ((p.b == q.a || p.b == q.b) && p.b < movable);
  };
  for (std::size_t e = edges.size(); e-- > 0;) {
    std::vector<bool> used(edges.size() + 1, false);
    for (std::size_t f = e + 1; f < edges.size(); ++f) {
      if (meet(edges[e], edges[f])) used[static_cast<std::size_t>(colors[f])] = true;
    }
    const auto free = std::find(used.begin(), used.end(), false);
    colors[e] = static_cast<std::int32_t>(free - used.begin());
  }
  return colors;
}

}  // namespace carom
