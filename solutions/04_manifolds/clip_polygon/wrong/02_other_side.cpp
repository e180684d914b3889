// Exercise 04.clip_polygon: what is left of a polygon behind a plane?
// Check it with: ./course check 04.clip_polygon

#include "carom/manifold/clip_polygon.hpp"

namespace carom {

std::vector<Vector3> clipPolygon(std::span<const Vector3> polygon, const Vector3& normal,
                                 Real offset) {
  std::vector<Vector3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& from = polygon[i];
    const Vector3& to = polygon[(i + 1) % polygon.size()];
    const Real heightFrom = normal.dot(from) - offset;
    const Real heightTo = normal.dot(to) - offset;
    if (heightFrom >= 0) kept.push_back(from);
    // The edge crosses the plane: there a new corner is made.
    if ((heightFrom < 0 && heightTo > 0) || (heightFrom > 0 && heightTo < 0)) {
      kept.push_back(from + heightFrom / (heightFrom - heightTo) * (to - from));
    }
  }
  return kept;
}

}  // namespace carom
