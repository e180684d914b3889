// Exercise 03.sat_hulls: separating axes for two convex polyhedra.
// Check it with: ./course check 03.sat_hulls

#include "carom/detection/sat_hulls.hpp"

#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"
#include "carom/detection/interval.hpp"

namespace carom {
namespace {

// Given: the corners relative to A's origin, so that a large common part of both places cancels.
[[maybe_unused]] std::vector<Vector3> corners(const ConvexHull& hull, const Pose& pose,
                                              const Vector3& origin) {
  std::vector<Vector3> placed;
  for (const Vector3& vertex : hull.vertices) {
    placed.push_back(pose.R_WB * vertex + (pose.p_WB - origin));
  }
  return placed;
}

// Given: the shadow of corners on an axis of length one.
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
  // Given: a pair of edges must be better than the best so far by more than this.
  [[maybe_unused]] const Real tie = kAxisTie * (a.boundingRadius + b.boundingRadius);
  // Given: below this sine of the angle between them two edges count as parallel.
  [[maybe_unused]] constexpr Real kParallel = 1e-12;
  // a.faces[i].normal is a unit vector in the frame of A; A.R_WB turns it into the world.
  // a.edges[i].from and a.edges[i].to are numbers of corners.
  return todo<SeparatingAxis>("satHulls");
}

}  // namespace carom
