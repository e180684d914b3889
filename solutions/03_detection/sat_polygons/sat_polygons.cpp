// Exercise 03.sat_polygons: separating axes for two convex polygons.
// Check it with: ./course check 03.sat_polygons

#include "carom/detection/sat_polygons.hpp"

#include <limits>
#include <string>

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"
#include "carom/detection/interval.hpp"

namespace carom {
namespace {

// Given: the shadow of a polygon on an axis of length one.
[[maybe_unused]] Interval shadow(std::span<const Vector2> corners, const Vector2& axis) {
  const Real first = axis.dot(corners.front());
  Interval covered{first, first};
  for (const Vector2& corner : corners) {
    covered.low = std::min(covered.low, axis.dot(corner));
    covered.high = std::max(covered.high, axis.dot(corner));
  }
  return covered;
}

}  // namespace

SeparatingAxis satPolygons(std::span<const Vector2> a, std::span<const Vector2> b) {
  // Given: what is no polygon is refused.
  if (a.size() < 3 || b.size() < 3) {
    throw InvalidInput("satPolygons: a polygon needs 3 corners, but they have " +
                       std::to_string(a.size()) + " and " + std::to_string(b.size()));
  }
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();
  //# solution
  const auto tryNormals = [&](std::span<const Vector2> owner, AxisKind kind) {
    for (std::size_t i = 0; i < owner.size(); ++i) {
      // The edge, turned clockwise by a right angle; of length one, because depths are compared.
      const Vector2 edge = owner[(i + 1) % owner.size()] - owner[i];
      const Vector2 normal = Vector2(edge.y(), -edge.x()).normalized();
      const Interval onA = shadow(a, normal);
      const Interval onB = shadow(b, normal);
      const Real gap = std::max(onB.low - onA.high, onA.low - onB.high);
      if (gap <= best.separation) continue;

      const Real sign = onB.low - onA.high >= onA.low - onB.high ? 1 : -1;
      best.separation = gap;
      best.axis = {sign * normal.x(), sign * normal.y(), 0};
      best.kind = kind;
      best.featureA = kind == AxisKind::faceOfA ? static_cast<int>(i) : -1;
      best.featureB = kind == AxisKind::faceOfB ? static_cast<int>(i) : -1;
    }
  };
  tryNormals(a, AxisKind::faceOfA);
  tryNormals(b, AxisKind::faceOfB);
  best.verdict = verdictOf(best.separation);
  return best;
  //# stub
  // For every edge: its normal, the two shadows, the gap between them. Keep the axis with the
  // largest gap in `best`. verdictOf(best.separation) turns a gap into a verdict.
  //#| return todo<SeparatingAxis>("satPolygons");
  //# end
}

}  // namespace carom
