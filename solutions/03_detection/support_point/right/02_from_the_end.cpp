// From the last corner to the first: then an equal one replaces.
#include "carom/core/errors.hpp"
#include "carom/detection/support_point.hpp"

namespace carom {

std::size_t supportPoint(std::span<const Vector3> points, const Vector3& direction) {
  if (points.empty()) throw InvalidInput("supportPoint: no points");
  std::size_t best = points.size() - 1;
  for (std::size_t i = points.size(); i-- > 0;) {
    const auto along = [&](std::size_t k) {
      return direction.x() * points[k].x() + direction.y() * points[k].y() +
             direction.z() * points[k].z();
    };
    if (along(i) >= along(best)) best = i;
  }
  return best;
}

}  // namespace carom
