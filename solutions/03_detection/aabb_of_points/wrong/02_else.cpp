// Exercise 03.aabb_of_points: the smallest box along the axes that holds a cloud of points.
// Check it with: ./course check 03.aabb_of_points

#include "carom/detection/aabb_of_points.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/errors.hpp"

namespace carom {

Aabb<3> aabbOfPoints(std::span<const Vector3> points) {
  if (points.empty()) throw InvalidInput("aabbOfPoints: there must be at least one point");
  for (const Vector3& point : points) requireFinite(point, "point");
  // The first point is a box of size zero: all that is known so far.
  Aabb<3> box;
  for (const Vector3& point : points) {
    for (int i = 0; i < 3; ++i) {
      if (point(i) < box.low(i))
        box.low(i) = point(i);
      else if (point(i) > box.high(i))
        box.high(i) = point(i);
    }
  }
  return box;
}

}  // namespace carom
