// Exercise 03.sat_hulls: separating axes for two convex polyhedra.
// Check it with: ./course check 03.sat_hulls

#include "carom/detection/sat_hulls.hpp"

#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/detection/interval.hpp"

namespace carom {
namespace {

[[maybe_unused]] std::vector<Vector3> corners(const ConvexHull& hull, const Pose& pose,
                                              const Vector3& origin) {
  std::vector<Vector3> placed;
  for (const Vector3& vertex : hull.vertices) {
    placed.push_back(pose.R_WB * vertex + (pose.p_WB - origin));
  }
  return placed;
}

[[maybe_unused]] Interval shadow(const std::vector<Vector3>& points, const Vector3& unitAxis) {
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
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();
  [[maybe_unused]] const Real tie = kAxisTie * (a.boundingRadius + b.boundingRadius);
  [[maybe_unused]] constexpr Real kParallel = 1e-12;
  const auto tryAxis = [&](const Vector3& axis, AxisKind kind, std::size_t i, std::size_t j) {
    const Interval onA = shadow(cornersA, axis);
    const Interval onB = shadow(cornersB, axis);
    const Real gap = gapBetween(onA, onB);
    if (gap <= best.separation + (kind == AxisKind::edges ? tie : 0)) return;
    best.separation = gap;
    best.axis = onB.low - onA.high >= onA.low - onB.high ? axis : Vector3(-axis);
    best.kind = kind;
    best.featureA = kind == AxisKind::faceOfB ? -1 : static_cast<int>(i);
    best.featureB = kind == AxisKind::faceOfA ? -1 : static_cast<int>(j);
  };

  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    tryAxis(A.R_WB * a.faces[i].normal, AxisKind::faceOfA, i, 0);
  }
  for (std::size_t j = 0; j < b.faces.size(); ++j) {
    tryAxis(B.R_WB * b.faces[j].normal, AxisKind::faceOfB, 0, j);
  }
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    const Vector3 edgeA = cornersA[a.edges[i].to] - cornersA[a.edges[i].from];
    tryAxis(edgeA / edgeA.norm(), AxisKind::edges, i, 0);
  }
  for (std::size_t j = 0; j < b.edges.size(); ++j) {
    const Vector3 edgeB = cornersB[b.edges[j].to] - cornersB[b.edges[j].from];
    tryAxis(edgeB / edgeB.norm(), AxisKind::edges, 0, j);
  }
  best.verdict = verdictOf(best.separation);
  return best;
}

}  // namespace carom
