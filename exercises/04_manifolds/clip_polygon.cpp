// Exercise 04.clip_polygon: what is left of a polygon behind a plane?
// Check it with: ./course check 04.clip_polygon

#include "carom/manifold/clip_polygon.hpp"

#include "carom/core/todo.hpp"

namespace carom {

std::vector<Vector3> clipPolygon(std::span<const Vector3> polygon, const Vector3& normal,
                                 Real offset) {
  // normal.dot(corner) - offset is negative behind the plane, zero on it, positive in front.
  return todo<std::vector<Vector3>>("clipPolygon");
}

}  // namespace carom
