// All axes in a list first; shadows from the eight corners.
#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/detection/sat_boxes.hpp"

namespace carom {
namespace {

struct Candidate {
  Vector3 axis;
  AxisKind kind;
  int i, j;
};

// Smallest and largest coordinate of a box's corners, relative to a point.
void ends(const Box& box, const Pose& pose, const Vector3& origin, const Vector3& axis, Real& low,
          Real& high) {
  low = std::numeric_limits<Real>::infinity();
  high = -low;
  for (int n = 0; n < 8; ++n) {
    const Vector3 corner(n & 1 ? box.halfExtents.x() : -box.halfExtents.x(),
                         n & 2 ? box.halfExtents.y() : -box.halfExtents.y(),
                         n & 4 ? box.halfExtents.z() : -box.halfExtents.z());
    const Real along = axis.dot(pose.R_WB * corner + (pose.p_WB - origin));
    low = std::min(low, along);
    high = std::max(high, along);
  }
}

}  // namespace

SeparatingAxis satBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  std::vector<Candidate> candidates;
  for (int i = 0; i < 3; ++i) candidates.push_back({A.R_WB.col(i), AxisKind::faceOfA, i, -1});
  for (int j = 0; j < 3; ++j) candidates.push_back({B.R_WB.col(j), AxisKind::faceOfB, -1, j});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector3 across = cross(A.R_WB.col(i), B.R_WB.col(j));
      if (across.norm() > 1e-12) {
        candidates.push_back({across.normalized(), AxisKind::edges, i, j});
      }
    }
  }
  const Real tie = kAxisTie * (a.halfExtents.norm() + b.halfExtents.norm());
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();
  for (const Candidate& c : candidates) {
    Real lowA, highA, lowB, highB;
    ends(a, A, A.p_WB, c.axis, lowA, highA);
    ends(b, B, A.p_WB, c.axis, lowB, highB);
    const Real gap = std::max(lowB - highA, lowA - highB);
    if (gap > best.separation + (c.kind == AxisKind::edges ? tie : 0)) {
      const bool forwards = lowB - highA >= lowA - highB;
      best = {verdictOf(gap), gap, forwards ? c.axis : Vector3(-c.axis), c.kind, c.i, c.j};
    }
  }
  return best;
}

}  // namespace carom
