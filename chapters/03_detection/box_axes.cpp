// Which axes do two boxes need?

// First two cubes that cross edge over edge, just apart and just overlapping: no face shows which.
// Then cubes with parallel edges: their cross products have no direction but rounding, and a
// program that does not know it believes them.

#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/project.hpp"
#include "carom/detection/sat_boxes.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom_io/table.hpp"

using carom::Box;
using carom::Pose;
using carom::Quaternion;
using carom::Real;
using carom::SeparatingAxis;
using carom::Vector3;

std::vector<Vector3> corners(const Box& box, const Pose& pose) {
  std::vector<Vector3> points;
  for (int i = 0; i < 8; ++i) {
    const Vector3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    points.push_back(carom::pointToWorld(pose, sign.cwiseProduct(box.halfExtents)));
  }
  return points;
}

struct Best {
  Real gap = -std::numeric_limits<Real>::infinity();  // [m]
  bool isEdge = false;
};

//! [naive]
// All fifteen axes, and no thought for edges that are parallel.
Best withoutGuard(const Box& a, const Pose& A, const Box& b, const Pose& B, bool edges) {
  Best best;
  const auto tryAxis = [&](const Vector3& axis, bool isEdge) {
    if (axis.isZero(0)) return;
    const carom::Interval onA = carom::project(corners(a, A), axis);
    const carom::Interval onB = carom::project(corners(b, B), axis);
    const Real gap = carom::gapBetween(onA, onB);
    if (gap > best.gap) best = {gap, isEdge};
  };
  for (int i = 0; i < 3; ++i) tryAxis(A.R_WB.col(i), false);
  for (int j = 0; j < 3; ++j) tryAxis(B.R_WB.col(j), false);
  for (int k = 0; k < 9 && edges; ++k) {
    tryAxis(carom::cross(A.R_WB.col(k / 3), B.R_WB.col(k % 3)), true);
  }
  return best;
}
//! [naive]

void printCrossing() {
  const Real s = std::sqrt(0.5), eighth = carom::cosine(0.39269908169872414);
  const Real sineEighth = carom::sine(0.39269908169872414);
  const Box cube{Vector3::Ones()};
  carom::io::Table table;
  table.column("cubes").column("best face [m]", carom::io::fixed(3));
  table.column("best of 15 [m]", carom::io::fixed(3)).column("made of");
  for (const Real gap : {0.1, -0.1}) {
    // Turned by 45 degrees about y and about x: an upper edge along y, a lower one along x.
    const Pose A = carom::poseOf({eighth, 0, sineEighth, 0}, Vector3::Zero());
    const Pose B = carom::poseOf({eighth, sineEighth, 0, 0}, {0, 0, 4 * s + gap});
    const SeparatingAxis best = carom::satBoxes(cube, A, cube, B);
    table.row({gap > 0 ? "0.1 m apart" : "overlapping by 0.1 m",
               withoutGuard(cube, A, cube, B, false).gap, best.separation,
               best.kind == carom::AxisKind::edges ? "two edges" : "a face"});
  }
  std::cout << table;
}

void printParallel() {
  carom::Random random(11);
  const Box cube{Vector3::Ones()};
  int edgesWithout = 0, edgesWith = 0;
  constexpr int kPairs = 2000;
  for (int i = 0; i < kPairs; ++i) {
    Quaternion q;
    for (Real* part : {&q.w, &q.x, &q.y, &q.z}) *part = random.between(-1, 1);
    // B as seen by A: 1.9 m along x, a little aside, not turned. Both are turned by q, the second
    // one in two halves of a turn, so that the matrices differ in their last digits.
    const Pose A = carom::poseOf(q, Vector3::Zero());
    const Quaternion there{0.6, 0.8, 0, 0}, back{0.6, -0.8, 0, 0};
    const Quaternion again = carom::hamiltonProduct(carom::hamiltonProduct(q, there), back);
    const Pose B{carom::poseOf(again, Vector3::Zero()).R_WB, A.R_WB * Vector3(1.9, 0.3, 0.2)};
    edgesWithout += withoutGuard(cube, A, cube, B, true).isEdge;
    edgesWith += carom::satBoxes(cube, A, cube, B).kind == carom::AxisKind::edges;
  }
  carom::io::Table table;
  table.column("fifteen axes").column("pairs").column("a face is best").column("two edges are");
  table.row({"no guard", kPairs, kPairs - edgesWithout, edgesWithout});
  table.row({"satBoxes", kPairs, kPairs - edgesWith, edgesWith});
  std::cout << table;
}

int main() {
  std::cout << "Two cubes of 2 m, edge across edge: signed gaps\n\n";
  printCrossing();
  std::cout << "\nTwo cubes side by side, overlapping by 0.1 m, in many orientations\n\n";
  printParallel();
}
