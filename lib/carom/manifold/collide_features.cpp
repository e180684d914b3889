#include "carom/manifold/collide_features.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/detection/gjk.hpp"
#include "carom/detection/separating_axis.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/manifold/facing_feature.hpp"
#include "carom/manifold/loop_manifold.hpp"

namespace carom {
namespace {

using detail::ClipCorner;
using detail::FacingFeature;

constexpr std::int32_t kReference = 1 << 20;
// Sine of the angle below which a sharp edge lies along another line: its ends are then off it by
// a ten-millionth of the length.
constexpr Real kParallelEdges = 1e-7;

bool isPolyhedron(const detail::ShapeView& shape) {
  return std::holds_alternative<const Box*>(shape) ||
         std::holds_alternative<const ConvexHull*>(shape);
}

// A face as the reference, a face or a line held against it. `normal` points out of the reference.
void clipAgainstFace(const FacingFeature& face, const FacingFeature& other, bool faceIsA,
                     const Vector3& normal, const Vector3& worldOrigin, Real limit,
                     Manifold& manifold) {
  const Vector3& origin = face.corners[0];
  const Vector3 u = (face.corners[1] - origin).normalized();
  const Vector3 v = cross(face.normal, u);
  const detail::Shear shear(face.normal, u, v, normal);
  ClipCorner first[detail::kMostCorners], second[detail::kMostCorners];
  ClipCorner* loop = first;
  ClipCorner* spare = second;
  int count = other.count;
  for (int k = 0; k < count; ++k) {
    const Vector3 corner = other.corners[k] - origin;
    first[k] = shear({corner.dot(u), corner.dot(v), corner.dot(face.normal), k});
  }
  for (int i = 0; i < face.count; ++i) {
    const Vector3 from = face.corners[i] - origin;
    const Vector3 to = face.corners[i + 1 < face.count ? i + 1 : 0] - origin;
    const Real x = from.dot(u), y = from.dot(v);
    const Real dx = to.dot(u) - x, dy = to.dot(v) - y;
    const auto outside = [=](const ClipCorner& c) { return (c.x - x) * dy - (c.y - y) * dx; };
    if (other.count == 2) {
      // A line is no loop: its ends move to the cut, each in its place.
      const Real at0 = outside(loop[0]), at1 = outside(loop[1]);
      if (at0 > 0 && at1 > 0) return;
      if (at0 <= 0 && at1 <= 0) continue;
      const int moved = at0 > 0 ? 0 : 1;
      const ClipCorner& fixed = loop[1 - moved];
      const Real part = outside(fixed) / (outside(fixed) - outside(loop[moved]));
      loop[moved] = {fixed.x + part * (loop[moved].x - fixed.x),
                     fixed.y + part * (loop[moved].y - fixed.y),
                     fixed.height + part * (loop[moved].height - fixed.height), kReference + i};
    } else {
      count = detail::clipLoop(loop, count, kReference + i, outside, 0, spare);
      std::swap(loop, spare);
    }
  }
  const auto idOf = [faceIsA](std::uint32_t ofFace, std::uint32_t ofOther) {
    return faceIsA ? (ofFace << 16) | ofOther : (ofOther << 16) | ofFace;
  };
  const auto name = [&](std::int32_t before, std::int32_t after) -> std::uint32_t {
    if (other.count == 2) {
      return after < kReference ? idOf(face.faceName, other.cornerNames[after])
                                : idOf(face.edgeNames[after - kReference], other.edgeNames[0]);
    }
    if (before < kReference && after < kReference) {
      return idOf(face.faceName, other.cornerNames[after]);
    }
    if (before >= kReference && after >= kReference) {
      const int i = before - kReference, j = after - kReference;
      return idOf(face.cornerNames[(i + 1) % face.count == j ? j : i], other.faceName);
    }
    return idOf(face.edgeNames[std::max(before, after) - kReference],
                other.edgeNames[std::min(before, after)]);
  };
  const detail::ReferencePlane plane{worldOrigin + origin, u, v, normal};
  detail::fillFromLoop(plane, loop, count, limit, name, manifold);
}

// Two lines side by side: the ends of the part that they have in common.
void compareLines(const FacingFeature& a, const FacingFeature& b, Real mostSine,
                  const Vector3& normal, const Vector3& worldOrigin, Real limit,
                  Manifold& manifold) {
  const Vector3 along = a.corners[1] - a.corners[0];
  const Vector3 other = b.corners[1] - b.corners[0];
  const Real square = along.squaredNorm();
  const Real lengths = square * other.squaredNorm();
  if (!(cross(along, other).squaredNorm() < mostSine * mostSine * lengths)) return;
  // B's ends as fractions of A's line.
  const Real start = (b.corners[0] - a.corners[0]).dot(along) / square;
  const Real end = (b.corners[1] - a.corners[0]).dot(along) / square;
  const Real low = std::max(Real(0), std::min(start, end));
  const Real high = std::min(Real(1), std::max(start, end));
  if (!(low < high)) return;
  for (const Real part : {low, high}) {
    const Vector3 onA = a.corners[0] + part * along;
    const Vector3 onB = b.corners[0] + (part - start) / (end - start) * other;
    const Real separation = normal.dot(onB - onA);
    if (separation > limit) continue;
    ManifoldPoint& point = manifold.points[manifold.count++];
    point.position = worldOrigin + (onA + onB) / 2;
    point.separation = separation;
    // The end belongs to the body whose line ends there.
    const bool endOfA = part == 0 || part == 1;
    const bool first = endOfA ? part == 0 : (part == low) == (start < end);
    point.id = endOfA ? (a.cornerNames[first ? 0 : 1] << 16) | b.edgeNames[0]
                      : (a.edgeNames[0] << 16) | b.cornerNames[first ? 0 : 1];
  }
  if (manifold.count == 0) return;
  manifold.areaCentroid =
      (manifold.points[0].position + manifold.points[manifold.count - 1].position) / 2;
}

}  // namespace

Manifold detail::collideFeaturesOf(const ShapeView& a, const Pose& A, const ShapeView& b,
                                   const Pose& B, Real margin) {
  Manifold manifold;
  const Separation gap = gjkOfCores(coreOfView(a), A, coreOfView(b), B, nullptr);
  if (gap.separation > margin) return manifold;
  manifold.normal = gap.normal;

  // Both features relative to A's origin.
  FacingFeature onA, onB;
  detail::facingFeature(a, A.R_WB, Vector3::Zero(), gap.normal, onA);
  detail::facingFeature(b, B.R_WB, B.p_WB - A.p_WB, -gap.normal, onB);
  const Real reach = onA.corners[0].cwiseAbs().sum() + onB.corners[0].cwiseAbs().sum();
  const Real limit = std::max(margin, gap.separation + kAxisTie * reach);
  const Vector3 against = -gap.normal;
  if (onA.count > 2 && onB.count > 2) {
    const Real cosineA = onA.normal.dot(gap.normal), cosineB = onB.normal.dot(against);
    const bool tie = std::abs(cosineA - cosineB) <= kAxisTie;
    if (tie ? tieScore(gap.normal) >= 0 : cosineA > cosineB) {
      clipAgainstFace(onA, onB, true, gap.normal, A.p_WB, limit, manifold);
    } else {
      clipAgainstFace(onB, onA, false, against, A.p_WB, limit, manifold);
    }
  } else if (onA.count > 2 && onB.count == 2) {
    clipAgainstFace(onA, onB, true, gap.normal, A.p_WB, limit, manifold);
  } else if (onB.count > 2 && onA.count == 2) {
    clipAgainstFace(onB, onA, false, against, A.p_WB, limit, manifold);
  } else if (onA.count == 2 && onB.count == 2) {
    // The line of a capsule or cylinder rolls under another; a sharp edge crosses it in one point.
    const bool sharp = isPolyhedron(a) || isPolyhedron(b);
    compareLines(onA, onB, sharp ? kParallelEdges : detail::kFacingSine, gap.normal, A.p_WB, limit,
                 manifold);
  }
  detail::keepDeepest((gap.pointA + gap.pointB) / 2, gap.separation, reach,
                      (onA.cornerNames[0] << 16) | onB.cornerNames[0], manifold);
  return manifold;
}

Manifold collideFeatures(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                         Real margin) {
  return detail::collideFeaturesOf(detail::viewOfShape(a), A, detail::viewOfShape(b), B, margin);
}

}  // namespace carom
