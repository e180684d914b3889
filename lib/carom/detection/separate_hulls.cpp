#include "carom/detection/separate_hulls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/variant.hpp"
#include "carom/detection/exact_vector.hpp"
#include "carom/detection/sat_hulls.hpp"

namespace carom {
namespace {

using detail::HullAxis;
using detail::HullPair;
using detail::HullView;

constexpr Real kRounding = 64 * 1.1102230246251565e-16;

// The corners of both bodies, rounded for looking and exact for deciding.
class ExactJudge {
 public:
  ExactJudge(const HullView& a, const Pose& A, const HullView& b, const Pose& B, Real reach)
      : a_(a), A_(A), b_(b), B_(B), reach_(reach) {
    for (int i = 0; i < a.vertexCount; ++i) cornersA_.push_back(A.R_WB * a.vertices[i]);
    for (int i = 0; i < b.vertexCount; ++i) {
      cornersB_.push_back(B.R_WB * b.vertices[i] + (B.p_WB - A.p_WB));
    }
  }

  // The largest exact gap of those that may be zero or more; `approximate` if there are none.
  Real largestGap(Real approximate) {
    best_ = -std::numeric_limits<Real>::infinity();
    for (int f = 0; f < a_.faceCount; ++f) {
      const auto [i, j, k] = threeCorners(a_, f);
      tryAxis({cornersA_, A_, a_, i, j}, {cornersA_, A_, a_, i, k});
    }
    for (int f = 0; f < b_.faceCount; ++f) {
      const auto [i, j, k] = threeCorners(b_, f);
      tryAxis({cornersB_, B_, b_, i, j}, {cornersB_, B_, b_, i, k});
    }
    for (int i = 0; i < a_.edgeCount; ++i) {
      for (int j = 0; j < b_.edgeCount; ++j) {
        tryAxis({cornersA_, A_, a_, a_.edges[i].from, a_.edges[i].to},
                {cornersB_, B_, b_, b_.edges[j].from, b_.edges[j].to});
      }
    }
    return std::isfinite(best_) ? best_ : approximate;
  }

 private:
  // The vector between two corners of a body.
  struct Edge {
    const std::vector<Vector3>& corners;
    const Pose& pose;
    const HullView& hull;
    int from, to;

    Vector3 rounded() const {
      return corners[to] - corners[from];
    }
    ExactVector exactly() const {
      return exactPoint(pose, hull.vertices[to]) - exactPoint(pose, hull.vertices[from]);
    }
  };
  struct Three {
    int i, j, k;
  };

  static Three threeCorners(const HullView& hull, int f) {
    const HullHalfEdge* side = hull.halfEdges + hull.faces[f].firstHalfEdge;
    return {side[0].origin, side[1].origin, side[2].origin};
  }

  // The gap on the cross product of two edges, if it may be zero or more.
  void tryAxis(const Edge& first, const Edge& second) {
    const Vector3 u = first.rounded(), v = second.rounded();
    const Vector3 axis = cross(u, v);
    const Real rounding = kRounding * reach_ * reach_ * (u.norm() + v.norm());
    Real lowA, highA, lowB, highB;
    cover(cornersA_, axis, lowA, highA);
    cover(cornersB_, axis, lowB, highB);
    const Real forwards = lowB - highA, backwards = lowA - highB;
    if (std::max(forwards, backwards) < -rounding) return;
    const ExactVector exactAxis = cross(first.exactly(), second.exactly());
    const Real length = carom::rounded(exactAxis).norm();
    if (length == 0) return;
    if (forwards >= -rounding) {
      const ExactNumber gap = extreme(cornersB_, B_, b_, axis, exactAxis, lowB + rounding, true) -
                              extreme(cornersA_, A_, a_, axis, exactAxis, highA - rounding, false);
      best_ = std::max(best_, gap.value() / length);
    }
    if (backwards >= -rounding) {
      const ExactNumber gap = extreme(cornersA_, A_, a_, axis, exactAxis, lowA + rounding, true) -
                              extreme(cornersB_, B_, b_, axis, exactAxis, highB - rounding, false);
      best_ = std::max(best_, gap.value() / length);
    }
  }

  static void cover(const std::vector<Vector3>& corners, const Vector3& axis, Real& low,
                    Real& high) {
    low = high = axis.dot(corners[0]);
    for (const Vector3& corner : corners) {
      low = std::min(low, axis.dot(corner));
      high = std::max(high, axis.dot(corner));
    }
  }

  // The exact coordinate of the lowest (highest) corner, among those that rounding leaves.
  static ExactNumber extreme(const std::vector<Vector3>& corners, const Pose& pose,
                             const HullView& hull, const Vector3& axis,
                             const ExactVector& exactAxis, Real limit, bool lowest) {
    ExactNumber best;
    bool found = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Real coordinate = axis.dot(corners[i]);
      if (lowest ? coordinate > limit : coordinate < limit) continue;
      const ExactNumber exactly = dot(exactPoint(pose, hull.vertices[i]), exactAxis);
      const int sign = found ? (exactly - best).sign() : 0;
      if (!found || (lowest ? sign < 0 : sign > 0)) best = exactly;
      found = true;
    }
    return best;
  }

  HullView a_;
  const Pose& A_;
  HullView b_;
  const Pose& B_;
  Real reach_;
  Real best_ = 0;
  std::vector<Vector3> cornersA_, cornersB_;  // relative to A's origin
};

SeparatingAxis separateOrdered(const HullView& a, const Pose& A, const HullView& b, const Pose& B) {
  const HullPair pair = detail::hullPair(a, A, b, B);
  const HullAxis best = detail::bestHullAxis(pair, nullptr, std::numeric_limits<Real>::infinity());
  SeparatingAxis result;
  result.separation = best.separation;
  result.axis = A.R_WB * best.normal;
  result.kind = best.kind;
  result.featureA = best.kind == AxisKind::faceOfB ? -1 : best.featureA;
  result.featureB = best.kind == AxisKind::faceOfA ? -1 : best.featureB;
  if (std::abs(best.separation) <= best.error) {
    result.separation = ExactJudge(a, A, b, B, pair.reach).largestGap(best.separation);
  }
  result.verdict = verdictOf(result.separation);
  return result;
}

SeparatingAxis separateViews(const HullView& a, const Pose& A, const HullView& b, const Pose& B) {
  if (detail::comesSecond(a, A, b, B)) return swapped(separateOrdered(b, B, a, A));
  return separateOrdered(a, A, b, B);
}

}  // namespace

namespace detail {

bool comesSecond(const HullView& a, const Pose& A, const HullView& b, const Pose& B) {
  if (const int order = comparePoses(A, B); order != 0) return order > 0;
  if (a.vertexCount != b.vertexCount) return a.vertexCount > b.vertexCount;
  for (int i = 0; i < a.vertexCount; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Real ofA = a.vertices[i][k], ofB = b.vertices[i][k];
      if (ofA != ofB) return ofA > ofB;
    }
  }
  return false;
}

}  // namespace detail

SeparatingAxis separateHulls(const ConvexHull& a, const Pose& A, const ConvexHull& b,
                             const Pose& B) {
  if (takesPlainPath()) return satHulls(a, A, b, B);
  return separateViews(detail::viewOf(a), A, detail::viewOf(b), B);
}

SeparatingAxis separateBoxAndHull(const Box& a, const Pose& A, const ConvexHull& b, const Pose& B) {
  if (takesPlainPath()) return satHulls(boxHull(a.halfExtents), A, b, B);
  const detail::BoxHullView box(a);
  return separateViews(box.view(), A, detail::viewOf(b), B);
}

}  // namespace carom
