// The walk begins with the edge that closes the polygon, and a crossing is measured from the end
// that is kept.
#include "carom/manifold/clip_polygon.hpp"

namespace carom {

std::vector<Vector3> clipPolygon(std::span<const Vector3> polygon, const Vector3& normal,
                                 Real offset) {
  std::vector<Vector3> kept;
  if (polygon.empty()) return kept;
  const auto height = [&](const Vector3& p) { return normal.dot(p) - offset; };
  Vector3 from = polygon.back();
  for (const Vector3& to : polygon) {
    const bool wasIn = height(from) < 0;
    const bool isIn = height(to) < 0;
    if (wasIn && height(to) > 0) {
      kept.push_back(from + height(from) / (height(from) - height(to)) * (to - from));
    } else if (isIn && height(from) > 0) {
      kept.push_back(to + height(to) / (height(to) - height(from)) * (from - to));
    }
    if (height(to) <= 0) kept.push_back(to);
    from = to;
  }
  return kept;
}

}  // namespace carom
