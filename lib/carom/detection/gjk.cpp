#include "carom/detection/gjk.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/core_shape.hpp"
#include "carom/detection/expanding_polytope.hpp"
#include "carom/detection/gjk_loop.hpp"
#include "carom/detection/parallel_axes.hpp"
#include "carom/detection/segment_segment.hpp"

namespace carom {
namespace {

using detail::CoreKind;
using detail::CorePair;
using detail::CoreShape;
using detail::GjkEnd;

// How far the farthest point of a core is from the body's origin, at most.
Real reachOf(const CoreShape& core) {
  if (core.kind == CoreKind::hull) return core.hull->centroid.norm() + core.hull->boundingRadius;
  return core.extents.x() + core.extents.y() + core.extents.z();
}

Vector3 centerOf(const CoreShape& core, const Pose& pose) {
  return core.kind == CoreKind::hull ? Vector3(pose.R_WB * core.hull->centroid) : Vector3::Zero();
}

Simplex<3> warmSimplex(const CorePair& pair, const SimplexCache* cache) {
  Simplex<3> simplex;
  if (cache == nullptr) return simplex;
  for (std::int32_t i = 0; i < cache->count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    SimplexVertex<3>& vertex = simplex.vertices[static_cast<std::size_t>(simplex.count)];
    if (pair.corners(cache->idA[k], cache->idB[k], vertex)) ++simplex.count;
  }
  return simplex;
}

void remember(SimplexCache* cache, const Simplex<3>& simplex, const Vector3& normal) {
  if (cache == nullptr) return;
  cache->count = simplex.count;
  for (int i = 0; i < simplex.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    cache->idA[k] = simplex.vertices[k].idA;
    cache->idB[k] = simplex.vertices[k].idB;
  }
  cache->direction = normal;
}

// Points and segments that meet: square to both is a shortest way out.
Vector3 squareToBoth(const CoreShape& a, const Pose& A, const CoreShape& b, const Pose& B) {
  const bool lineA = a.kind == CoreKind::segment, lineB = b.kind == CoreKind::segment;
  if (!lineA && !lineB) return Vector3::UnitZ();
  const Vector3 axisA = lineA ? A.R_WB.col(2) : B.R_WB.col(2);
  const Vector3 axisB = lineB ? B.R_WB.col(2) : axisA;
  Vector3 n = cross(axisA, axisB);
  if (!(n.squaredNorm() > 1e-24)) {  // parallel but for rounding: anything square to the line
    int least = 0;
    axisA.cwiseAbs().minCoeff(&least);
    n = cross(axisA, Vector3::Unit(least));
  }
  // The cross product of nearly parallel lines leans by its own rounding; straighten it up.
  n.normalize();
  n -= n.dot(axisA) * axisA;
  n -= n.dot(axisB) * axisB;
  return n.normalized();
}

// Points and segments: closed form, from A's origin.
Separation ofThinCores(const CoreShape& a, const Pose& A, const CoreShape& b, const Pose& B,
                       const Vector3& p_AB) {
  const Vector3 u = A.R_WB.col(2) * a.extents.z(), v = B.R_WB.col(2) * b.extents.z();
  const SegmentPair pair = closestPoints(-u, u, p_AB - v, p_AB + v);
  Separation result;
  result.pointA = pair.pointA;
  result.pointB = pair.pointB;
  // The gap is square to a segment of which the nearest point is not an end, and at an end it leads
  // away from the segment. Rounding makes a gap lean the other way; that is taken out.
  const Vector3 axisA = A.R_WB.col(2), axisB = B.R_WB.col(2);
  const Real endA = pair.insideA ? 0 : (pair.pointA == u ? 1 : -1);
  const Real endB = pair.insideB ? 0 : (pair.pointB == p_AB + v ? 1 : -1);
  Vector3 gap = pair.pointB - pair.pointA;
  const Real size = a.extents.z() + b.extents.z() + length(p_AB);
  const Real sine = cross(axisA, axisB).norm();
  if (pair.insideA && pair.insideB && sine * size > length(gap)) {
    const Vector3 n = squareToBoth(a, A, b, B);
    gap = n.dot(gap) * n;
  } else {
    // Of a segment so short that its other end is no nearer, to rounding, it says nothing whether
    // the point is an end.
    const auto matters = [&gap](Real along, Real halfLength) {
      return 2 * std::abs(along) * halfLength >
             8 * std::numeric_limits<Real>::epsilon() * gap.squaredNorm();
    };
    const Real alongA = gap.dot(axisA);
    // The point goes along: an end and the foot beside it can be equally near, to rounding.
    if (matters(alongA, a.extents.z()) && endA * alongA <= 0) {
      gap -= alongA * axisA;
      result.pointA += alongA * axisA;
    }
    const Real alongB = gap.dot(axisB);
    if (matters(alongB, b.extents.z()) && endB * -alongB <= 0) {
      gap -= alongB * axisB;
      result.pointB -= alongB * axisB;
    }
  }
  result.separation = length(gap);
  // A gap of the size of the rounding error of its ends has no direction.
  if (result.separation > 16 * std::numeric_limits<Real>::epsilon() * size) {
    result.normal = gap / result.separation;
  } else {
    result.normal = squareToBoth(a, A, b, B);
    if (result.normal.dot(gap) < 0) result.normal = -result.normal;
    result.separation = result.normal.dot(gap);
  }
  return result;
}

Separation ofCores(const CoreShape& a, const Pose& A, const CoreShape& b, const Pose& B,
                   const Vector3& p_AB, SimplexCache* cache) {
  const CorePair pair(a, A.R_WB, b, B.R_WB, p_AB);
  const Real size = reachOf(a) + reachOf(b) + p_AB.lpNorm<1>();
  Simplex<3> simplex = warmSimplex(pair, cache);
  Vector3 start = centerOf(a, A) - centerOf(b, B) - p_AB;
  if (cache != nullptr && !cache->direction.isZero(0)) start = -cache->direction;
  if (start.isZero(0)) start = Vector3::UnitX();
  const detail::GjkResult<3> found = detail::runGjk<3>(pair, simplex, start, size);

  Separation result;
  result.iterations = found.iterations;
  if (found.end != GjkEnd::unclear) {
    result.separation = found.lower;
    result.normal = found.direction;
    witnessPoints(simplex, result.pointA, result.pointB);
    // The nearest points are known to rounding, the distance along a face's normal a little better.
    result.status = SeparationStatus::converged;
    result.errorBound = 0;
    const Real noise = 64 * std::numeric_limits<Real>::epsilon() * size;
    if (found.upper - found.lower > noise) {
      result.separation = found.upper;
      result.errorBound = found.upper - std::max(found.lower, Real(0));
      if (found.end == GjkEnd::stalled) result.status = SeparationStatus::stalled;
    }
    remember(cache, simplex, result.normal);
    return result;
  }
  const detail::Penetration depth = detail::expandPolytope(pair, simplex, size);
  result.iterations += depth.iterations;
  result.separation = -depth.depth;
  result.normal = depth.normal;
  result.pointA = depth.pointA;
  result.pointB = depth.pointB;
  result.errorBound = depth.errorBound;
  if (depth.flat) {  // thinner than rounding: all that is known is that they meet
    result.normal = -start / length(start);
    witnessPoints(simplex, result.pointA, result.pointB);
    result.errorBound = size;
  }
  result.status = result.errorBound > 0 ? SeparationStatus::stalled : SeparationStatus::converged;
  remember(cache, simplex, result.normal);
  return result;
}

}  // namespace

namespace detail {

Separation gjkOfCores(const CoreShape& a, const Pose& A, const CoreShape& b, const Pose& B,
                      SimplexCache* cache) {
  const Vector3 p_AB = B.p_WB - A.p_WB;
  const auto thin = [](const CoreShape& core) {
    return core.kind == CoreKind::point || core.kind == CoreKind::segment;
  };
  Separation result;
  if (thin(a) && thin(b)) {
    result = ofThinCores(a, A, b, B, p_AB);
  } else if (!separateParallel(a, A.R_WB, b, B.R_WB, p_AB, result)) {
    result = ofCores(a, A, b, B, p_AB, cache);
  }
  result.separation -= a.radius + b.radius;
  result.pointA += A.p_WB + a.radius * result.normal;
  result.pointB += A.p_WB - b.radius * result.normal;
  return result;
}

}  // namespace detail

Separation gjk(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
               SimplexCache* cache) {
  const auto toCore = [](const auto& shape) { return detail::coreOf(shape); };
  return detail::gjkOfCores(std::visit(toCore, a), A, std::visit(toCore, b), B, cache);
}

}  // namespace carom
