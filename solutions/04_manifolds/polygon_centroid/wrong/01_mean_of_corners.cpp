#include "carom/manifold/polygon_centroid.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {

PolygonArea polygonCentroid(std::span<const Vector3> polygon) {
  if (polygon.empty()) throw InvalidInput("polygonCentroid: the polygon must have corners");
  Vector3 doubled = Vector3::Zero();
  Vector3 mean = Vector3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& next = polygon[(i + 1) % polygon.size()];
    doubled += cross(polygon[i] - polygon[0], next - polygon[0]);
    mean += polygon[i] / static_cast<Real>(polygon.size());
  }
  return {doubled.norm() / 2, mean};
}

}  // namespace carom
