// Without shadows: of A only the edge's own line matters for A's normals, because A lies behind it.
#include <limits>

#include "carom/core/errors.hpp"
#include "carom/detection/sat_polygons.hpp"

namespace carom {

SeparatingAxis satPolygons(std::span<const Vector2> a, std::span<const Vector2> b) {
  if (a.size() < 3 || b.size() < 3) throw InvalidInput("a polygon needs 3 corners");
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();
  for (const bool ofA : {true, false}) {
    const auto owner = ofA ? a : b;
    const auto other = ofA ? b : a;
    for (std::size_t i = 0; i < owner.size(); ++i) {
      const Vector2& p = owner[i];
      const Vector2 edge = (i + 1 < owner.size() ? owner[i + 1] : owner[0]) - p;
      const Vector2 out = Vector2(edge.y(), -edge.x()) / edge.norm();
      // Forwards: until the other lies beyond the edge. Backwards would be longer, or is found at
      // another edge, unless the figure has parallel edges; both are looked at.
      Real nearest = out.dot(other[0]);
      Real farthest = nearest;
      for (const Vector2& q : other) {
        nearest = std::min(nearest, out.dot(q));
        farthest = std::max(farthest, out.dot(q));
      }
      Real low = out.dot(p);
      for (const Vector2& q : owner) low = std::min(low, out.dot(q));
      const Real ahead = nearest - out.dot(p);
      const Real behind = low - farthest;
      const Real gap = ahead >= behind ? ahead : behind;
      if (gap > best.separation) {
        const bool along = ofA == (ahead >= behind);
        const Vector2 axis = along ? out : Vector2(-out);
        best = {verdictOf(gap),
                gap,
                Vector3(axis.x(), axis.y(), 0),
                ofA ? AxisKind::faceOfA : AxisKind::faceOfB,
                ofA ? static_cast<int>(i) : -1,
                ofA ? -1 : static_cast<int>(i)};
      }
    }
  }
  return best;
}

}  // namespace carom
