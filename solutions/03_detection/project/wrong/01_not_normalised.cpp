// Exercise 03.project: the shadow of a body on an axis.
// Check it with: ./course check 03.project

#include "carom/detection/project.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"

namespace carom {

Interval project(std::span<const Vector3> points, const Vector3& axis) {
  if (points.empty()) throw InvalidInput("project: there must be at least one point");
  requireFinite(axis, "axis");
  requirePositive(length(axis), "length of the axis");
  const Real axisLength = 1;
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
