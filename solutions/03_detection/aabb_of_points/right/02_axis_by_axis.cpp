// One axis after the other, each with the standard search for both ends.
#include "carom/detection/aabb_of_points.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"

namespace carom {

Aabb<3> aabbOfPoints(std::span<const Vector3> points) {
  if (points.empty()) throw InvalidInput("a box needs a point");
  Aabb<3> box;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Vector3& p : points) {
      if (!std::isfinite(p[axis])) throw InvalidInput("a coordinate is not finite");
    }
    const auto ends = std::minmax_element(
        points.begin(), points.end(),
        [axis](const Vector3& p, const Vector3& q) { return p[axis] < q[axis]; });
    box.low[axis] = (*ends.first)[axis];
    box.high[axis] = (*ends.second)[axis];
  }
  return box;
}

}  // namespace carom
