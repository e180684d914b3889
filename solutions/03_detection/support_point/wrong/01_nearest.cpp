// Exercise 03.support_point: which corner of a body lies farthest in a direction?
// Check it with: ./course check 03.support_point

#include "carom/detection/support_point.hpp"

#include "carom/core/errors.hpp"

namespace carom {

std::size_t supportPoint(std::span<const Vector3> points, const Vector3& direction) {
  if (points.empty()) throw InvalidInput("supportPoint: there must be at least one point");
  std::size_t farthest = 0;
  Real reach = direction.dot(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Real along = direction.dot(points[i]);
    if (along < reach) {
      farthest = i;
      reach = along;
    }
  }
  return farthest;
}

}  // namespace carom
