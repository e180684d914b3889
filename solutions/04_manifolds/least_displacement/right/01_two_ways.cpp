// Each axis is two directions; of all directions the one with the largest gap wins.
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/manifold/least_displacement.hpp"

namespace carom {

LeastDisplacement leastDisplacement(std::span<const Vector3> axes, std::span<const Vector3> a,
                                    std::span<const Vector3> b) {
  if (axes.empty() || a.empty() || b.empty()) throw InvalidInput("nothing to push");
  LeastDisplacement best;
  best.separation = -std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!axes[i].allFinite() || axes[i].isZero(0)) throw InvalidInput("an axis has no direction");
    for (const int sign : {1, -1}) {
      const Vector3 way = sign * axes[i].normalized();
      Real farthest = way.dot(a[0]);
      for (const Vector3& p : a) farthest = std::max(farthest, way.dot(p));
      Real nearest = way.dot(b[0]);
      for (const Vector3& q : b) nearest = std::min(nearest, way.dot(q));
      if (nearest - farthest > best.separation) {
        best.separation = nearest - farthest;
        best.normal = way;
        best.axis = static_cast<int>(i);
      }
    }
  }
  return best;
}

}  // namespace carom
