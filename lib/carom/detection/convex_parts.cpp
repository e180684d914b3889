#include "carom/detection/convex_parts.hpp"

#include <string>

#include "carom/core/errors.hpp"
#include "carom/detection/sat_polygons.hpp"

namespace carom {

Verdict convexParts(std::span<const std::vector<Vector2>> partsA,
                    std::span<const std::vector<Vector2>> partsB) {
  if (partsA.empty() || partsB.empty()) {
    throw InvalidInput("convexParts: a figure must have at least one part, but they have " +
                       std::to_string(partsA.size()) + " and " + std::to_string(partsB.size()));
  }
  Verdict verdict = Verdict::separated;
  for (const std::vector<Vector2>& partA : partsA) {
    for (const std::vector<Vector2>& partB : partsB) {
      const Verdict pair = satPolygons(partA, partB).verdict;
      if (pair == Verdict::overlapping) return Verdict::overlapping;
      if (pair == Verdict::touching) verdict = Verdict::touching;
    }
  }
  return verdict;
}

}  // namespace carom
