// The standard search; it keeps the first of equals.
#include <algorithm>

#include "carom/core/errors.hpp"
#include "carom/detection/support_point.hpp"

namespace carom {

std::size_t supportPoint(std::span<const Vector3> points, const Vector3& direction) {
  if (points.empty()) throw InvalidInput("supportPoint: no points");
  const auto farthest = std::max_element(
      points.begin(), points.end(),
      [&](const Vector3& p, const Vector3& q) { return p.dot(direction) < q.dot(direction); });
  return static_cast<std::size_t>(farthest - points.begin());
}

}  // namespace carom
