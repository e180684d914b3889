#include "carom/detection/signed_distance.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "carom/core/length.hpp"
#include "carom/detection/closest_point.hpp"
#include "carom/detection/gap_sign.hpp"
#include "carom/detection/limits.hpp"
#include "carom/detection/planar_gjk.hpp"
#include "carom/detection/rounded_distance.hpp"
#include "carom/detection/separate_boxes.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/detection/support.hpp"

namespace carom {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

// One sum tells whether all twelve numbers are of a usable size; what is wrong is found out only then. Summed
// in columns, so that the additions need not wait for one another.
void requireFinitePose(const Pose& pose, const char* name) {
  const Vector3 sums = (pose.R_WB.col(0) + pose.R_WB.col(1)) + (pose.R_WB.col(2) + pose.p_WB);
  const Real sum = sums.x() + sums.y() + sums.z();
  if (!(std::abs(sum) <= kLargestLength)) requireUsable(pose, name);
}

Separation swapped(Separation s) {
  s.normal = -s.normal;
  std::swap(s.pointA, s.pointB);
  return s;
}

// A ball against anything: its centre against the surface.
template <class Other>
Separation ballAgainst(const Ball& ball, const Pose& A, const Other& other, const Pose& B) {
  const SurfacePoint found = detail::closestInBody(other, pointToBody(B, A.p_WB));
  Separation result;
  result.normal = directionToWorld(B, -found.normal);
  result.separation = found.distance - ball.radius;
  result.pointA = A.p_WB + ball.radius * result.normal;
  result.pointB = pointToWorld(B, found.point);
  return result;
}

Separation ballAgainst(const Ball& a, const Pose& A, const Ball& b, const Pose& B) {
  const Vector3 way = B.p_WB - A.p_WB;
  const Real distance = length(way);
  Separation result;
  if (distance > 0) result.normal = way / distance;
  result.separation = distance - (a.radius + b.radius);
  // Near touching the difference of the roots loses its digits; that of the squares need not.
  if (std::abs(result.separation) <= 0x1p-10 * distance) {
    result.separation = preciseGap(A.p_WB, a.radius, B.p_WB, b.radius);
  }
  result.pointA = A.p_WB + a.radius * result.normal;
  result.pointB = B.p_WB - b.radius * result.normal;
  return result;
}

template <class T>
constexpr bool kIsPolyhedron = std::is_same_v<T, Box> || std::is_same_v<T, ConvexHull>;

SeparatingAxis exactAxis(const Box& a, const Pose& A, const Box& b, const Pose& B) {
  return separateBoxes(a, A, b, B);
}
SeparatingAxis exactAxis(const Box& a, const Pose& A, const ConvexHull& b, const Pose& B) {
  return separateBoxAndHull(a, A, b, B);
}
SeparatingAxis exactAxis(const ConvexHull& a, const Pose& A, const Box& b, const Pose& B) {
  return separateBoxAndHull(b, B, a, A);  // only its sign is used
}
SeparatingAxis exactAxis(const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B) {
  return separateHulls(a, A, b, B);
}

// Touching, or a rounding away from it: the verdict comes from exact numbers.
template <class SA, class SB>
void decideSign(const SA& a, const Pose& A, const SB& b, const Pose& B, Separation& result) {
  const Real size = (B.p_WB - A.p_WB).norm() + (result.pointA - A.p_WB).norm();
  if (std::abs(result.separation) > 64 * std::numeric_limits<Real>::epsilon() * size) return;
  const SeparatingAxis axis = exactAxis(a, A, b, B);
  const bool agrees = (axis.verdict == Verdict::separated && result.separation > 0) ||
                      (axis.verdict == Verdict::overlapping && result.separation < 0);
  if (axis.verdict == Verdict::touching) {
    result.separation = 0;
  } else if (!agrees) {
    result.separation = axis.separation;
  }
}

template <class SA, class SB>
Separation ofConvex(const SA& a, const Pose& A, const SB& b, const Pose& B, SimplexCache* cache,
                    bool decides) {
  if constexpr (std::is_same_v<SA, Ball>) {
    return ballAgainst(a, A, b, B);
  } else if constexpr (std::is_same_v<SB, Ball>) {
    return swapped(ballAgainst(b, B, a, A));
  } else {
    Separation result = detail::gjkOfCores(detail::coreOf(a), A, detail::coreOf(b), B, cache);
    if constexpr (kIsPolyhedron<SA> && kIsPolyhedron<SB>) {
      if (decides) decideSign(a, A, b, B, result);
    }
    return result;
  }
}

// How far a convex shape reaches against the normal of a half-space A.
template <class Convex>
Separation halfSpaceAgainst(const HalfSpace& space, const Pose& A, const Convex& shape,
                            const Pose& B) {
  Separation result;
  result.normal = directionToWorld(A, space.normal);
  const Vector3 lowest = supportOf(shape, directionToBody(B, -result.normal)).point;
  result.pointB = pointToWorld(B, lowest);
  // From the half-space's own origin, so that nothing is lost far from the world's.
  const Vector3 fromA = directionToWorld(B, lowest) + (B.p_WB - A.p_WB);
  result.separation = result.normal.dot(fromA) - space.offset;
  result.pointA = result.pointB - result.separation * result.normal;
  return result;
}

Separation halfSpaces(const HalfSpace& a, const Pose& A, const HalfSpace& b, const Pose& B) {
  Separation result;
  result.normal = directionToWorld(A, a.normal);
  const Vector3 other = directionToWorld(B, b.normal);
  // Only exactly opposite walls do not meet somewhere.
  if (result.normal != -other) {
    result.separation = -kInfinity;
    return result;
  }
  result.pointA = A.p_WB + a.offset * result.normal;
  result.pointB = B.p_WB + b.offset * other;
  result.separation = result.normal.dot(result.pointB - result.pointA);
  result.pointB = result.pointA + result.separation * result.normal;
  return result;
}

struct AnyPair {
  const Pose& A;
  const Pose& B;
  SimplexCache* cache;
  bool decides = true;  // the sign of what touches

  Separation operator()(const HalfSpace& a, const HalfSpace& b) const {
    return halfSpaces(a, A, b, B);
  }
  template <class SA, class SB>
  Separation operator()(const SA& a, const SB& b) const {
    if constexpr (std::is_same_v<SA, Compound>) {
      return nearestPart(a, A, [&](const auto& part, const Pose& placed) {
        return AnyPair{placed, B, nullptr, decides}(part, b);
      });
    } else if constexpr (std::is_same_v<SB, Compound>) {
      return nearestPart(b, B, [&](const auto& part, const Pose& placed) {
        return AnyPair{A, placed, nullptr, decides}(a, part);
      });
    } else if constexpr (std::is_same_v<SA, HalfSpace>) {
      return halfSpaceAgainst(a, A, b, B);
    } else if constexpr (std::is_same_v<SB, HalfSpace>) {
      return swapped(halfSpaceAgainst(b, B, a, A));
    } else {
      return ofConvex(a, A, b, B, cache, decides);
    }
  }

 private:
  template <class Against>
  static Separation nearestPart(const Compound& compound, const Pose& pose,
                                const Against& against) {
    Separation best;
    best.separation = kInfinity;
    int iterations = 0;
    for (const CompoundPart& part : compound.parts) {
      const Pose placed = composed(pose, part.pose);
      const Separation found =
          std::visit([&](const auto& shape) { return against(shape, placed); }, part.shape);
      iterations += found.iterations;
      if (found.separation < best.separation) best = found;
    }
    best.iterations = iterations;
    return best;
  }
};

// The plane. A polygon has no radius, a disc no corners.
struct PlanarPair {
  const PlanarPose& A;
  const PlanarPose& B;

  PlanarSeparation operator()(const Disc& a, const Disc& b) const {
    const Pose placedA{Matrix3::Identity(), {A.p_WB.x(), A.p_WB.y(), 0}};
    const Pose placedB{Matrix3::Identity(), {B.p_WB.x(), B.p_WB.y(), 0}};
    Separation found = ballAgainst(Ball{a.radius}, placedA, Ball{b.radius}, placedB);
    PlanarSeparation result;
    result.separation = found.separation;
    // Two discs about one centre: any direction of the plane will do.
    if (A.p_WB != B.p_WB) result.normal = found.normal.head<2>();
    result.pointA = A.p_WB + a.radius * result.normal;
    result.pointB = B.p_WB - b.radius * result.normal;
    return result;
  }
  PlanarSeparation operator()(const Disc& a, const Polygon& b) const {
    const OutlinePoint found = closestPoint(PlanarShape(b), B, A.p_WB);
    PlanarSeparation result;
    result.normal = -found.normal;
    result.separation = found.distance - a.radius;
    result.pointA = A.p_WB + a.radius * result.normal;
    result.pointB = found.point;
    return result;
  }
  PlanarSeparation operator()(const Polygon& a, const Disc& b) const {
    PlanarSeparation result = PlanarPair{B, A}(b, a);
    result.normal = -result.normal;
    std::swap(result.pointA, result.pointB);
    return result;
  }
  PlanarSeparation operator()(const Polygon& a, const Polygon& b) const {
    return planarGjk(a, A, b, B);
  }
  template <class SA, class SB>
  PlanarSeparation operator()(const SA& a, const SB& b) const {
    if constexpr (std::is_same_v<SA, PlanarCompound>) {
      return nearestPart(a, A, [&](const auto& part, const PlanarPose& placed) {
        return PlanarPair{placed, B}(part, b);
      });
    } else {
      return nearestPart(b, B, [&](const auto& part, const PlanarPose& placed) {
        return PlanarPair{A, placed}(a, part);
      });
    }
  }

 private:
  template <class Against>
  static PlanarSeparation nearestPart(const PlanarCompound& compound, const PlanarPose& pose,
                                      const Against& against) {
    PlanarSeparation best;
    best.separation = kInfinity;
    for (const PlanarCompoundPart& part : compound.parts) {
      const PlanarPose placed = composed(pose, part.pose);
      const PlanarSeparation found =
          std::visit([&](const auto& shape) { return against(shape, placed); }, part.shape);
      if (found.separation < best.separation) best = found;
    }
    return best;
  }
};

}  // namespace

Separation signedDistance(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                          SimplexCache* cache) {
  requireFinitePose(A, "pose of A");
  requireFinitePose(B, "pose of B");
  return std::visit(AnyPair{A, B, cache}, a, b);
}

Separation signedDistance(const Shape& a, const Pose& A, const Shape& b, const Pose& B,
                          SimplexCache* cache) {
  requireFinitePose(A, "pose of A");
  requireFinitePose(B, "pose of B");
  return std::visit(AnyPair{A, B, cache}, a, b);
}

Separation roundedDistance(const Shape& a, const Pose& A, const Shape& b, const Pose& B) {
  requireFinitePose(A, "pose of A");
  requireFinitePose(B, "pose of B");
  return std::visit(AnyPair{A, B, nullptr, false}, a, b);
}

PlanarSeparation signedDistance(const PlanarShape& a, const PlanarPose& A, const PlanarShape& b,
                                const PlanarPose& B) {
  requireUsable(A, "pose of A");
  requireUsable(B, "pose of B");
  return std::visit(PlanarPair{A, B}, a, b);
}

}  // namespace carom
