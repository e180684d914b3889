// Exercise 04.polygon_centroid: area and centre of a flat polygon in space.
// Check it with: ./course check 04.polygon_centroid

#include "carom/manifold/polygon_centroid.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {
namespace {

// its length.
[[maybe_unused]] Vector3 centerOfOutline(std::span<const Vector3> polygon) {
  Real around = 0;
  Vector3 moment = Vector3::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3 from = polygon[i] - polygon[0];
    const Vector3 to = polygon[(i + 1) % polygon.size()] - polygon[0];
    around += (to - from).norm();
    moment += (to - from).norm() / 2 * (from + to);
  }
  return around > 0 ? Vector3(polygon[0] + moment / around) : polygon[0];
}

}  // namespace

PolygonArea polygonCentroid(std::span<const Vector3> polygon) {
  if (polygon.empty()) throw InvalidInput("polygonCentroid: the polygon must have corners");

  // Which way the polygon faces, and its size: the sum of the triangles' doubled area vectors.
  Vector3 doubled = Vector3::Zero();
  // largest squared distance from the first corner
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    doubled += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  const Real doubledArea = doubled.norm();
  // What rounding alone would leave of a line's area.

  // Triangles that look the other way than the whole count negative.
  Vector3 moment = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vector3 b = polygon[i] - polygon[0];
    const Vector3 c = polygon[i + 1] - polygon[0];
    const Real weight = cross(b, c).dot(doubled) / doubledArea;
    moment += weight * (b + c) / 3;
  }
  return {doubledArea / 2, polygon[0] + moment / doubledArea};
}

}  // namespace carom
