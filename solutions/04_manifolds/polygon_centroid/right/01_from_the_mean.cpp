// The fan starts at the mean of the corners; a line is halved between its ends.
#include <algorithm>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/manifold/polygon_centroid.hpp"

namespace carom {

PolygonArea polygonCentroid(std::span<const Vector3> polygon) {
  if (polygon.empty()) throw InvalidInput("no corners");
  const std::size_t n = polygon.size();
  Vector3 mean = Vector3::Zero();
  for (const Vector3& p : polygon) mean += p / static_cast<Real>(n);
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    sum += cross(polygon[i] - mean, polygon[(i + 1) % n] - mean) / 2;
  }
  const Real area = sum.norm();
  Real longest = 0;
  Vector3 middle = polygon[0];
  for (const Vector3& p : polygon) {
    for (const Vector3& q : polygon) {
      if ((p - q).squaredNorm() > longest) {
        longest = (p - q).squaredNorm();
        middle = (p + q) / 2;
      }
    }
  }
  if (area <= 1e-15 * longest) return {0, middle};
  Vector3 centroid = mean;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector3 b = polygon[i] - mean;
    const Vector3 c = polygon[(i + 1) % n] - mean;
    centroid += cross(b, c).dot(sum) / (2 * area * area) * (b + c) / 3;
  }
  return {area, centroid};
}

}  // namespace carom
