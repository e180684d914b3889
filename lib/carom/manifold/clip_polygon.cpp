#include "carom/manifold/clip_polygon.hpp"

namespace carom {

std::vector<Vector3> clipPolygon(std::span<const Vector3> polygon, const Vector3& normal,
                                 Real offset) {
  std::vector<Vector3> kept;
  if (polygon.empty()) return kept;

  // The walk starts with the edge that closes the polygon.
  Vector3 from = polygon.back();
  Real heightFrom = normal.dot(from) - offset;
  for (const Vector3& to : polygon) {
    const Real heightTo = normal.dot(to) - offset;
    if (heightFrom < 0 && heightTo > 0) {
      kept.push_back(from + heightFrom / (heightFrom - heightTo) * (to - from));
    } else if (heightFrom > 0 && heightTo < 0) {
      kept.push_back(to + heightTo / (heightTo - heightFrom) * (from - to));
    }
    if (heightTo <= 0) kept.push_back(to);
    from = to;
    heightFrom = heightTo;
  }
  return kept;
}

}  // namespace carom
