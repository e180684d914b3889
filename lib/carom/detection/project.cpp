#include "carom/detection/project.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Interval project(std::span<const Vector3> points, const Vector3& axis) {
  if (points.empty()) throw InvalidInput("project: there must be at least one point");
  const Real axisLength = length(axis);
  if (!(axisLength > 0) || !axis.allFinite()) {
    reject("project: axis", toText(axis), "must be finite and not zero");
  }

  // The first point starts the interval: starting from zero would draw every shadow to the origin.
  const Real first = points.front().dot(axis) / axisLength;
  Interval shadow{first, first};
  for (const Vector3& point : points) {
    const Real coordinate = point.dot(axis) / axisLength;
    shadow.low = std::min(shadow.low, coordinate);
    shadow.high = std::max(shadow.high, coordinate);
  }
  return shadow;
}

}  // namespace carom
