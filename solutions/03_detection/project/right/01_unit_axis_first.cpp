// The axis is made a unit vector first, and the coordinates are collected and sorted.
#include <algorithm>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/project.hpp"

namespace carom {

Interval project(std::span<const Vector3> points, const Vector3& axis) {
  if (points.empty() || !axis.allFinite() || axis.isZero(0)) {
    throw InvalidInput("a shadow needs points and a direction");
  }
  const Vector3 unit = axis.normalized();
  std::vector<Real> coordinates;
  for (const Vector3& p : points) coordinates.push_back(unit.dot(p));
  std::sort(coordinates.begin(), coordinates.end());
  return {coordinates.front(), coordinates.back()};
}

}  // namespace carom
