#include "carom/detection/planar_gjk.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/detection/gjk_loop.hpp"
#include "carom/detection/separate_polygons.hpp"
#include "carom/detection/support.hpp"

namespace carom {
namespace {

// Support points of A - B, from A's origin along the world's axes.
struct PolygonPair {
  const Polygon& a;
  const Polygon& b;
  const PlanarPose& A;
  const PlanarPose& B;
  Vector2 p_AB;

  SimplexVertex<2> operator()(const Vector2& d) const {
    const PlanarSupport onA = supportOf(a, directionToBody(A, d));
    const PlanarSupport onB = supportOf(b, directionToBody(B, -d));
    const Vector2 p = directionToWorld(A, onA.point);
    const Vector2 q = directionToWorld(B, onB.point) + p_AB;
    return {p - q, p, q, onA.id, onB.id};
  }
};

std::vector<Vector2> placed(const Polygon& polygon, const PlanarPose& pose, const Vector2& offset) {
  std::vector<Vector2> corners;
  for (const Vector2& v : polygon.vertices) corners.push_back(directionToWorld(pose, v) + offset);
  return corners;
}

// The outward normal of the edge from corner i to the next.
Vector2 outwardOf(const std::vector<Vector2>& corners, std::size_t i) {
  const Vector2 side = corners[(i + 1) % corners.size()] - corners[i];
  return Vector2(side.y(), -side.x()).normalized();
}

// The edge that looks most in a direction.
std::size_t edgeFacing(const std::vector<Vector2>& corners, const Vector2& direction) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (outwardOf(corners, i).dot(direction) > outwardOf(corners, best).dot(direction)) best = i;
  }
  return best;
}

// The corner of `other` that is deepest behind an edge of `owner`, and the point of the edge above
// it. If the corner is beside the edge, a parallel edge of `other` is deepest as a whole, and the
// point of it beneath the edge's end is taken.
void edgeAndCorner(const std::vector<Vector2>& owner, std::size_t i,
                   const std::vector<Vector2>& other, const Vector2& outward, Real separation,
                   Vector2& onOwner, Vector2& onOther) {
  const Vector2& from = owner[i];
  const Vector2& to = owner[(i + 1) % owner.size()];
  const Vector2 along = (to - from).normalized();
  Vector2 deepest = other[0];
  for (const Vector2& corner : other) {
    if (outward.dot(corner - deepest) < 0) deepest = corner;
  }
  const Real where = std::clamp(along.dot(deepest - from), Real(0), (to - from).norm());
  onOwner = from + where * along;
  onOther = onOwner + separation * outward;
}

}  // namespace

PlanarSeparation planarGjk(const Polygon& a, const PlanarPose& A, const Polygon& b,
                           const PlanarPose& B) {
  const PolygonPair pair{a, b, A, B, B.p_WB - A.p_WB};
  Real size = pair.p_AB.norm();
  for (const Polygon* polygon : {&a, &b}) {
    Real reach = 0;
    for (const Vector2& v : polygon->vertices) reach = std::max(reach, v.norm());
    size += reach;
  }
  Simplex<2> simplex;
  const Vector2 start = pair.p_AB.isZero(0) ? Vector2(Vector2::UnitY()) : Vector2(-pair.p_AB);
  const detail::GjkResult<2> found = detail::runGjk<2>(pair, simplex, start, size);

  PlanarSeparation result;
  result.iterations = found.iterations;
  result.status = SeparationStatus::converged;
  if (found.end != detail::GjkEnd::unclear) {
    result.separation = found.lower;
    result.normal = found.direction;
    witnessPoints(simplex, result.pointA, result.pointB);
    if (found.end == detail::GjkEnd::stalled) {
      result.status = SeparationStatus::stalled;
      result.separation = found.upper;
      result.errorBound = found.upper - std::max(found.lower, Real(0));
    }
  } else {
    const std::vector<Vector2> cornersA = placed(a, A, Vector2::Zero());
    const std::vector<Vector2> cornersB = placed(b, B, pair.p_AB);
    const SeparatingAxis axis = separatePolygons(cornersA, cornersB);
    result.separation = axis.verdict == Verdict::touching ? 0 : axis.separation;
    result.normal = axis.axis.head<2>();
    result.status = SeparationStatus::exact;
    // Opposite edges share their axis, and so do parallel ones of both polygons: if the edge that
    // has given the axis looks the other way, another one lies where they overlap.
    bool ofA = axis.kind == AxisKind::faceOfA;
    auto edge = static_cast<std::size_t>(ofA ? axis.featureA : axis.featureB);
    const Real facing = ofA ? outwardOf(cornersA, edge).dot(result.normal)
                            : -outwardOf(cornersB, edge).dot(result.normal);
    if (facing < 0) {
      const std::size_t onA = edgeFacing(cornersA, result.normal);
      const std::size_t onB = edgeFacing(cornersB, -result.normal);
      ofA = outwardOf(cornersA, onA).dot(result.normal) >=
            -outwardOf(cornersB, onB).dot(result.normal);
      edge = ofA ? onA : onB;
    }
    if (ofA) {
      edgeAndCorner(cornersA, edge, cornersB, result.normal, result.separation, result.pointA,
                    result.pointB);
    } else {
      edgeAndCorner(cornersB, edge, cornersA, -result.normal, result.separation, result.pointB,
                    result.pointA);
    }
  }
  result.pointA += A.p_WB;
  result.pointB += A.p_WB;
  return result;
}

}  // namespace carom
