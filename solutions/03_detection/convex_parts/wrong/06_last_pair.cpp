// Exercise 03.convex_parts: figures that are not convex, cut into parts that are.
// Check it with: ./course check 03.convex_parts

#include "carom/detection/convex_parts.hpp"

#include "carom/core/errors.hpp"
#include "carom/detection/sat_polygons.hpp"

namespace carom {

Verdict convexParts(std::span<const std::vector<Vector2>> partsA,
                    std::span<const std::vector<Vector2>> partsB) {
  if (partsA.empty() || partsB.empty()) {
    throw InvalidInput("convexParts: a figure must have at least one part");
  }
  Verdict verdict = Verdict::separated;
  for (const std::vector<Vector2>& partA : partsA) {
    for (const std::vector<Vector2>& partB : partsB) {
      const Verdict pair = satPolygons(partA, partB).verdict;
      verdict = pair;
    }
  }
  return verdict;
}

}  // namespace carom
