#include "carom/detection/sat_hulls.hpp"

#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/detection/interval.hpp"

namespace carom {
namespace {

// The corners relative to A's origin: a large common part of both positions cancels exactly here.
std::vector<Vector3> corners(const ConvexHull& hull, const Pose& pose, const Vector3& origin) {
  std::vector<Vector3> placed;
  for (const Vector3& vertex : hull.vertices) {
    placed.push_back(pose.R_WB * vertex + (pose.p_WB - origin));
  }
  return placed;
}

Interval shadow(const std::vector<Vector3>& points, const Vector3& unitAxis) {
  const Real first = unitAxis.dot(points.front());
  Interval covered{first, first};
  for (const Vector3& point : points) {
    const Real coordinate = unitAxis.dot(point);
    covered.low = std::min(covered.low, coordinate);
    covered.high = std::max(covered.high, coordinate);
  }
  return covered;
}

}  // namespace

SeparatingAxis satHulls(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B) {
  const std::vector<Vector3> cornersA = corners(a, A, A.p_WB);
  const std::vector<Vector3> cornersB = corners(b, B, A.p_WB);
  const Real tie = kAxisTie * (a.boundingRadius + b.boundingRadius);
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();

  // Keeps an axis that is better by more than `margin`, turned so that it points from A to B.
  const auto tryAxis = [&](const Vector3& axis, AxisKind kind, int i, int j, Real margin) {
    const Interval onA = shadow(cornersA, axis);
    const Interval onB = shadow(cornersB, axis);
    const Real gap = gapBetween(onA, onB);
    if (gap <= best.separation + margin) return;
    best.separation = gap;
    best.axis = onB.low - onA.high >= onA.low - onB.high ? axis : Vector3(-axis);
    best.kind = kind;
    best.featureA = i;
    best.featureB = j;
  };

  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    tryAxis(A.R_WB * a.faces[i].normal, AxisKind::faceOfA, static_cast<int>(i), -1, 0);
  }
  for (std::size_t j = 0; j < b.faces.size(); ++j) {
    tryAxis(B.R_WB * b.faces[j].normal, AxisKind::faceOfB, -1, static_cast<int>(j), 0);
  }
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    const Vector3 edgeA = cornersA[a.edges[i].to] - cornersA[a.edges[i].from];
    for (std::size_t j = 0; j < b.edges.size(); ++j) {
      const Vector3 edgeB = cornersB[b.edges[j].to] - cornersB[b.edges[j].from];
      const Vector3 axis = cross(edgeA, edgeB);
      const Real sizeOfAxis = axis.norm();
      // Parallel within 1e-12: no direction, and a face normal does as well.
      constexpr Real kParallel = 1e-12;
      if (sizeOfAxis <= kParallel * edgeA.norm() * edgeB.norm()) continue;
      tryAxis(axis / sizeOfAxis, AxisKind::edges, static_cast<int>(i), static_cast<int>(j), tie);
    }
  }
  best.verdict = verdictOf(best.separation);
  return best;
}

}  // namespace carom
