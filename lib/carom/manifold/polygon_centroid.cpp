#include "carom/manifold/polygon_centroid.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {
namespace {

// Each edge weighs by its length. Going there and back weighs every part of a line alike.
Vector3 centerOfOutline(std::span<const Vector3> polygon) {
  Real around = 0;
  Vector3 moment = Vector3::Zero();  // relative to the first corner
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3 from = polygon[i] - polygon[0];
    const Vector3 to = polygon[(i + 1) % polygon.size()] - polygon[0];
    const Real edge = (to - from).norm();
    around += edge;
    moment += edge / 2 * (from + to);
  }
  return around > 0 ? Vector3(polygon[0] + moment / around) : polygon[0];
}

}  // namespace

PolygonArea polygonCentroid(std::span<const Vector3> polygon) {
  if (polygon.empty()) throw InvalidInput("polygonCentroid: the polygon must have corners");

  // Measured from the middle of the corners: there the parts on either side round alike.
  Vector3 middle = Vector3::Zero();
  for (const Vector3& corner : polygon) middle += corner - polygon[0];
  middle = polygon[0] + middle / static_cast<Real>(polygon.size());

  // Which way the polygon faces, and its size: the sum of the triangles' doubled area vectors.
  Vector3 doubled = Vector3::Zero();
  Real reach = 0;  // largest squared distance from the middle
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3& next = polygon[(i + 1) % polygon.size()];
    doubled += cross(polygon[i] - middle, next - middle);
    reach = std::max(reach, (polygon[i] - middle).squaredNorm());
  }
  const Real doubledArea = doubled.norm();
  // What rounding alone would leave of a line's area.
  constexpr Real kRounding = 1e-15;
  if (!(doubledArea > kRounding * reach)) return {0, centerOfOutline(polygon)};

  // Triangles that look the other way than the whole count negative.
  Vector3 moment = Vector3::Zero();  // relative to the middle
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3 b = polygon[i] - middle;
    const Vector3 c = polygon[(i + 1) % polygon.size()] - middle;
    moment += cross(b, c).dot(doubled) / doubledArea * (b + c) / 3;
  }
  return {doubledArea / 2, middle + moment / doubledArea};
}

}  // namespace carom
