// Exercise 03.aabb_of_points: the smallest box along the axes that holds a cloud of points.
// Check it with: ./course check 03.aabb_of_points

#include "carom/detection/aabb_of_points.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Aabb<3> aabbOfPoints(std::span<const Vector3> points) {
  // Given: what is no cloud of points is refused.
  if (points.empty()) throw InvalidInput("aabbOfPoints: there must be at least one point");
  for (const Vector3& point : points) requireFinite(point, "point");
  // Aabb<3> box{low, high} makes a box; point(0), point(1), point(2) are a point's coordinates.
  return todo<Aabb<3>>("aabbOfPoints");
}

}  // namespace carom
