// Exercise 03.sat_boxes: fifteen separating axes for two boxes.
// Check it with: ./course check 03.sat_boxes

#include "carom/detection/sat_boxes.hpp"

#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"

namespace carom {
namespace {

// Given: half the length of a box's shadow on an axis of length one.
[[maybe_unused]] Real shadowRadius(const Box& box, const Pose& pose, const Vector3& axis) {
  const Vector3 axis_B = pose.R_WB.transpose() * axis;
  return box.halfExtents.dot(axis_B.cwiseAbs());
}

}  // namespace

SeparatingAxis satBoxes(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  // Given: from centre to centre.
  [[maybe_unused]] const Vector3 between = B.p_WB - A.p_WB;
  SeparatingAxis best;
  best.separation = -std::numeric_limits<Real>::infinity();
  // Given: a pair of edges must be better than the faces by more than this.
  [[maybe_unused]] const Real tie = kAxisTie * (a.halfExtents.norm() + b.halfExtents.norm());
  // Given: below this sine of the angle between them two edges count as parallel.
  [[maybe_unused]] constexpr Real kParallel = 1e-12;
  // A.R_WB.col(i) is the direction of axis i of box A in the world, of length one. The shadows'
  // middles are |between.dot(axis)| apart.
  return todo<SeparatingAxis>("satBoxes");
}

}  // namespace carom
