#include "carom/manifold/clip_polygon.hpp"

namespace carom {

std::vector<Vector3> clipPolygon(std::span<const Vector3> polygon, const Vector3& normal,
                                 Real offset) {
  std::vector<Vector3> kept;
  if (polygon.empty()) return kept;

  // A polygon that is only a line is walked there and back, and cut twice at the same place.
  const auto keep = [&kept](const Vector3& corner) {
    if (kept.empty() || kept.back() != corner) kept.push_back(corner);
  };

  // The walk starts with the edge that closes the polygon.
  Vector3 from = polygon.back();
  Real heightFrom = normal.dot(from) - offset;
  for (const Vector3& to : polygon) {
    const Real heightTo = normal.dot(to) - offset;
    if (heightFrom < 0 && heightTo > 0) {
      keep(from + heightFrom / (heightFrom - heightTo) * (to - from));
    } else if (heightFrom > 0 && heightTo < 0) {
      keep(to + heightTo / (heightTo - heightFrom) * (from - to));
    }
    if (heightTo <= 0) keep(to);
    from = to;
    heightFrom = heightTo;
  }
  if (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

}  // namespace carom
