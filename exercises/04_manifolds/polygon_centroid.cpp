// Exercise 04.polygon_centroid: area and centre of a flat polygon in space.
// Check it with: ./course check 04.polygon_centroid

#include "carom/manifold/polygon_centroid.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {
namespace {

// Given: the middle of a polygon that has been squeezed to a line or a point. Each edge weighs by
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
  // Given: a polygon without corners is refused.
  if (polygon.empty()) throw InvalidInput("polygonCentroid: the polygon must have corners");
  // cross(b, c) of two sides of a triangle is a vector as long as twice its area.
  // PolygonArea{area, centroid} makes an answer.
  return todo<PolygonArea>("polygonCentroid");
}

}  // namespace carom
