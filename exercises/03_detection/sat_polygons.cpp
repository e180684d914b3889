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
  // For every edge: its normal, the two shadows, the gap between them. Keep the axis with the
  // largest gap in `best`. verdictOf(best.separation) turns a gap into a verdict.
  return todo<SeparatingAxis>("satPolygons");
}

}  // namespace carom
