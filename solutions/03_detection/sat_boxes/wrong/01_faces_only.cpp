// Exercise 03.sat_boxes: fifteen separating axes for two boxes.
// Check it with: ./course check 03.sat_boxes

#include "carom/detection/sat_boxes.hpp"

#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"

namespace carom {
namespace {

[[maybe_unused]] Real shadowRadius(const Box& box, const Pose& pose, const Vector3& axis) {
  const Vector3 axis_B = pose.R_WB.transpose() * axis;
  return box.halfExtents.dot(axis_B.cwiseAbs());
}

}  // namespace

SeparatingAxis satBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  [[maybe_unused]] const Vector3 between = B.p_WB - A.p_WB;
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();
  [[maybe_unused]] const Real tie = kAxisTie * (a.halfExtents.norm() + b.halfExtents.norm());
  [[maybe_unused]] constexpr Real kParallel = 1e-12;
  const auto tryAxis = [&](const Vector3& axis, AxisKind kind, int i, int j, Real margin) {
    const Real distance = between.dot(axis);
    const Real gap = std::abs(distance) - shadowRadius(a, A, axis) - shadowRadius(b, B, axis);
    if (gap <= best.separation + margin) return;
    best.separation = gap;
    best.axis = distance < 0 ? Vector3(-axis) : axis;
    best.kind = kind;
    best.featureA = i;
    best.featureB = j;
  };

  for (int i = 0; i < 3; ++i) tryAxis(A.R_WB.col(i), AxisKind::faceOfA, i, -1, 0);
  for (int j = 0; j < 3; ++j) tryAxis(B.R_WB.col(j), AxisKind::faceOfB, -1, j, 0);
  best.verdict = verdictOf(best.separation);
  return best;
}

}  // namespace carom
