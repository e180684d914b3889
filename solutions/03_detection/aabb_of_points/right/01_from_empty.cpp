// From an empty box, coordinate by coordinate with Eigen.
#include "carom/core/checks.hpp"
#include "carom/core/errors.hpp"
#include "carom/detection/aabb_of_points.hpp"

namespace carom {

Aabb<3> aabbOfPoints(std::span<const Vector3> points) {
  if (points.empty()) throw InvalidInput("aabbOfPoints: there must be at least one point");
  Aabb<3> box;
  for (const Vector3& point : points) {
    requireFinite(point, "point");
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

}  // namespace carom
