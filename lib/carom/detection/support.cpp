#include "carom/detection/support.hpp"

#include <cmath>

#include "carom/core/length.hpp"

namespace carom {
namespace {

// Length one, whatever the length was; `fallback` for zero.
Vector3 unitOr(const Vector3& direction, const Vector3& fallback) {
  const Real whole = length(direction);
  if (whole > 1e-290) return direction / whole;
  const Vector3 scaled = scaledToOne(direction);
  return scaled.isZero(0) ? fallback : (scaled / scaled.norm()).eval();
}

Support farthestOfAll(const ConvexHull& hull, const Vector3& d) {
  const std::size_t count = hull.x.size();
  const Real* x = hull.x.data();
  const Real* y = hull.y.data();
  const Real* z = hull.z.data();
  std::size_t best = 0;
  Real reach = d.x() * x[0] + d.y() * y[0] + d.z() * z[0];
  for (std::size_t i = 1; i < count; ++i) {
    const Real along = d.x() * x[i] + d.y() * y[i] + d.z() * z[i];
    const bool farther = along > reach;
    reach = farther ? along : reach;
    best = farther ? i : best;
  }
  return {hull.vertices[best], static_cast<std::int32_t>(best)};
}

// A step goes to the farthest neighbour, strictly farther, so no corner is visited twice. Where
// rounding makes two neighbours equal the walk stops within rounding of the farthest.
Support farthestByWalking(const ConvexHull& hull, const Vector3& d, std::int32_t start) {
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  std::int32_t here = start;
  Real reach = d.dot(hull.vertices[at(here)]);
  while (true) {
    std::int32_t next = here;
    const std::int32_t first = hull.anyHalfEdge[at(here)];
    std::int32_t side = first;
    do {
      const HullHalfEdge& twin = hull.halfEdges[at(hull.halfEdges[at(side)].twin)];
      const Real along = d.dot(hull.vertices[at(twin.origin)]);
      if (along > reach) {
        reach = along;
        next = twin.origin;
      }
      side = twin.next;  // the next half-edge that starts here
    } while (side != first);
    if (next == here) return {hull.vertices[at(here)], here};
    here = next;
  }
}

}  // namespace

Support supportOf(const Ball& ball, const Vector3& direction) {
  return {ball.radius * unitOr(direction, Vector3::UnitZ()), -1};
}

Support supportOf(const Box& box, const Vector3& direction) {
  const Vector3& h = box.halfExtents;
  const bool x = direction.x() >= 0, y = direction.y() >= 0, z = direction.z() >= 0;
  return {{x ? h.x() : -h.x(), y ? h.y() : -h.y(), z ? h.z() : -h.z()},
          static_cast<std::int32_t>(x) + 2 * y + 4 * z};
}

Support supportOf(const Capsule& capsule, const Vector3& direction) {
  Vector3 point = capsule.radius * unitOr(direction, Vector3::UnitZ());
  point.z() += direction.z() >= 0 ? capsule.halfLength : -capsule.halfLength;
  return {point, -1};
}

Support supportOf(const Cylinder& cylinder, const Vector3& direction) {
  const Vector3 sideways =
      cylinder.radius * unitOr({direction.x(), direction.y(), 0}, Vector3::Zero());
  const Real z = direction.z() >= 0 ? cylinder.halfHeight : -cylinder.halfHeight;
  return {{sideways.x(), sideways.y(), z}, -1};
}

Support supportOf(const ConvexHull& hull, const Vector3& direction, std::int32_t start) {
  return hull.vertices.size() < kClimbAbove ? farthestOfAll(hull, direction)
                                            : farthestByWalking(hull, direction, start);
}

Support supportOf(const ConvexShape& shape, const Vector3& direction) {
  return std::visit([&](const auto& part) { return supportOf(part, direction); }, shape);
}

PlanarSupport supportOf(const Disc& disc, const Vector2& direction) {
  const Vector3 unit = unitOr({direction.x(), direction.y(), 0}, Vector3::UnitY());
  return {disc.radius * unit.head<2>(), -1};
}

PlanarSupport supportOf(const Polygon& polygon, const Vector2& direction) {
  std::size_t best = 0;
  Real reach = direction.dot(polygon.vertices[0]);
  for (std::size_t i = 1; i < polygon.vertices.size(); ++i) {
    const Real along = direction.dot(polygon.vertices[i]);
    if (along > reach) {
      reach = along;
      best = i;
    }
  }
  return {polygon.vertices[best], static_cast<std::int32_t>(best)};
}

}  // namespace carom
