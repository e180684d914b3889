#include "carom/impulse/projected_area.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/length.hpp"

namespace carom {

namespace {

constexpr Real kPi = std::numbers::pi;

// Each takes the unit direction d; `across` is its part perpendicular to the z axis.

Real shadow(const Ball& ball, const Vector3&) {
  return kPi * ball.radius * ball.radius;
}

Real shadow(const Box& box, const Vector3& d) {
  const Vector3& h = box.halfExtents;
  return 4 * (std::abs(d.x()) * h.y() * h.z() + std::abs(d.y()) * h.x() * h.z() +
              std::abs(d.z()) * h.x() * h.y());
}

Real shadow(const Capsule& capsule, const Vector3& d) {
  const Real across = std::hypot(d.x(), d.y());
  return capsule.radius * (kPi * capsule.radius + 4 * capsule.halfLength * across);
}

Real shadow(const Cylinder& cylinder, const Vector3& d) {
  const Real across = std::hypot(d.x(), d.y());
  return cylinder.radius *
         (kPi * cylinder.radius * std::abs(d.z()) + 4 * cylinder.halfHeight * across);
}

Real shadow(const ConvexHull& hull, const Vector3& d) {
  const auto corner = [&](std::int32_t halfEdge) -> const Vector3& {
    const auto origin = hull.halfEdges[static_cast<std::size_t>(halfEdge)].origin;
    return hull.vertices[static_cast<std::size_t>(origin)];
  };
  Real twice = 0;
  for (const HullFace& face : hull.faces) {
    const Vector3& first = corner(face.firstHalfEdge);
    Vector3 area = Vector3::Zero();  // twice the area, along the normal
    for (std::int32_t i = 1; i + 1 < face.count; ++i) {
      area +=
          cross(corner(face.firstHalfEdge + i) - first, corner(face.firstHalfEdge + i + 1) - first);
    }
    twice += std::abs(area.dot(d)) / 2;
  }
  return twice / 2;
}

}  // namespace

Real projectedArea(const ConvexShape& shape, const Vector3& direction) {
  requireFinite(direction, "direction");
  const Vector3 scaled = scaledToOne(direction);
  if (scaled == Vector3::Zero()) reject("direction", toText(direction), "must not be zero");
  const Vector3 d = scaled / scaled.norm();
  return std::visit([&d](const auto& solid) { return shadow(solid, d); }, shape);
}

}  // namespace carom
