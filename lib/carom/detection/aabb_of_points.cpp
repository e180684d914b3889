#include "carom/detection/aabb_of_points.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/errors.hpp"

namespace carom {

Aabb<3> aabbOfPoints(std::span<const Vector3> points) {
  if (points.empty()) throw InvalidInput("aabbOfPoints: there must be at least one point");

  // The first point is a box of size zero: all that is known so far.
  Aabb<3> box{points.front(), points.front()};
  for (const Vector3& point : points) {
    requireFinite(point, "point");
    for (int i = 0; i < 3; ++i) {
      if (point(i) < box.low(i)) box.low(i) = point(i);
      if (point(i) > box.high(i)) box.high(i) = point(i);
    }
  }
  return box;
}

}  // namespace carom
