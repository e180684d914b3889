// The verdicts are ranked, and the highest one wins.
#include <algorithm>

#include "carom/core/errors.hpp"
#include "carom/detection/convex_parts.hpp"
#include "carom/detection/sat_polygons.hpp"

namespace carom {

Verdict convexParts(std::span<const std::vector<Vector2>> partsA,
                    std::span<const std::vector<Vector2>> partsB) {
  if (partsA.empty() || partsB.empty()) throw InvalidInput("a figure has no parts");
  Real smallest = satPolygons(partsA[0], partsB[0]).separation;
  for (const auto& p : partsA) {
    for (const auto& q : partsB) smallest = std::min(smallest, satPolygons(p, q).separation);
  }
  return verdictOf(smallest);
}

}  // namespace carom
