// Exercise 03.project: the shadow of a body on an axis.
// Check it with: ./course check 03.project

#include "carom/detection/project.hpp"

#include <algorithm>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Interval project(std::span<const Vector3> points, const Vector3& axis) {
  // Given: without points or without a direction there is no shadow.
  if (points.empty()) throw InvalidInput("project: there must be at least one point");
  requireFinite(axis, "axis");
  requirePositive(length(axis), "length of the axis");
  // point.dot(axis) is the inner product, length(axis) the length of the axis. Interval{low, high}
  // makes an interval.
  return todo<Interval>("project");
}

}  // namespace carom
