#include "carom/detection/separate_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/variant.hpp"
#include "carom/detection/exact_number.hpp"
#include "carom/detection/sat_polygons.hpp"

namespace carom {
namespace {

// Exact gap on the normal of an edge, times the length of the edge.
ExactNumber exactGap(const Vector2& from, const Vector2& to, std::span<const Vector2> a,
                     std::span<const Vector2> b) {
  const ExactNumber nx = ExactNumber(to.y()) - ExactNumber(from.y());
  const ExactNumber ny = ExactNumber(from.x()) - ExactNumber(to.x());
  const auto cover = [&](std::span<const Vector2> corners, ExactNumber& low, ExactNumber& high) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const ExactNumber along = nx * ExactNumber(corners[i].x()) + ny * ExactNumber(corners[i].y());
      if (i == 0 || (along - low).sign() < 0) low = along;
      if (i == 0 || (along - high).sign() > 0) high = along;
    }
  };
  ExactNumber lowA, highA, lowB, highB;
  cover(a, lowA, highA);
  cover(b, lowB, highB);
  const ExactNumber forwards = lowB - highA, backwards = lowA - highB;
  return (forwards - backwards).sign() >= 0 ? forwards : backwards;
}

// Raises `best` to the largest exact gap on an owner's edges.
void tryExactly(std::span<const Vector2> owner, std::span<const Vector2> a,
                std::span<const Vector2> b, Real rounding, Real& best) {
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const Vector2& from = owner[i];
    const Vector2& to = owner[(i + 1) % owner.size()];
    const Vector2 edge = to - from;
    const Vector2 normal = Vector2(edge.y(), -edge.x()).normalized();
    constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
    Real lowA = kInfinity, highA = -kInfinity, lowB = kInfinity, highB = -kInfinity;
    for (const Vector2& corner : a) {
      lowA = std::min(lowA, normal.dot(corner - from));
      highA = std::max(highA, normal.dot(corner - from));
    }
    for (const Vector2& corner : b) {
      lowB = std::min(lowB, normal.dot(corner - from));
      highB = std::max(highB, normal.dot(corner - from));
    }
    // The direction of a short edge is as blurred as its ends are.
    if (std::max(lowB - highA, lowA - highB) < -rounding) continue;
    best = std::max(best, exactGap(from, to, a, b).value() / edge.norm());
  }
}

}  // namespace

SeparatingAxis separatePolygons(std::span<const Vector2> a, std::span<const Vector2> b) {
  SeparatingAxis result = satPolygons(a, b);
  if (takesPlainPath()) return result;
  Real reach = 0;
  for (const Vector2& corner : a) reach = std::max(reach, corner.cwiseAbs().maxCoeff());
  for (const Vector2& corner : b) reach = std::max(reach, corner.cwiseAbs().maxCoeff());
  // Coordinates, products and the unit normal round by a few units each; the difference of two
  // corners is rounded relative to itself, so short edges are no worse.
  const Real rounding = 64 * 1.1102230246251565e-16 * reach;
  if (std::abs(result.separation) <= rounding) {
    Real best = -std::numeric_limits<Real>::infinity();
    tryExactly(a, a, b, rounding, best);
    tryExactly(b, a, b, rounding, best);
    if (std::isfinite(best)) result.separation = best;
    result.verdict = verdictOf(result.separation);
  }
  return result;
}

}  // namespace carom
