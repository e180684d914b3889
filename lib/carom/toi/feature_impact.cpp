#include "carom/toi/feature_impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/detection/segment_segment.hpp"
#include "carom/toi/contact_filter.hpp"
#include "carom/toi/exact_contact.hpp"

namespace carom {
namespace {

// Where between a and b a point on the line through them is, 0 to 1.
Real alongEdge(const Vector3& point, const Vector3& a, const Vector3& b) {
  const Real squared = (b - a).squaredNorm();
  return squared > 0 ? std::min(std::max((point - a).dot(b - a) / squared, 0.0), 1.0) : 0;
}

// Weights of the corners of a triangle at a point of it: areas along the axis where they are
// largest. Without an area, the nearest edge.
std::array<Real, 4> weightsInFace(const std::array<Vector3, 4>& p) {
  const Vector3 foot = closestOnTriangle(p[0], p[1], p[2], p[3]);
  const Vector3 normal = cross(p[2] - p[1], p[3] - p[1]);
  Eigen::Index axis = 0;
  if (normal.cwiseAbs().maxCoeff(&axis) > 0) {
    const auto share = [&](std::size_t i, std::size_t j) {
      const Real area = cross(p[i] - foot, p[j] - foot)[axis] / normal[axis];
      return std::min(std::max(area, 0.0), 1.0);
    };
    const Real a = share(2, 3), b = std::min(share(3, 1), 1 - a);
    return {1, a, b, 1 - a - b};
  }
  std::array<Real, 4> best = {};
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 1; i < 4; ++i) {
    const std::size_t j = i % 3 + 1;
    const Vector3 onEdge = closestOnSegment(p[0], p[i], p[j]);
    const Real squared = (onEdge - p[0]).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    const Real s = alongEdge(onEdge, p[i], p[j]);
    best = {1, 0, 0, 0};
    best[i] = 1 - s, best[j] = s;
  }
  return best;
}

std::array<Real, 4> weightsOnEdges(const std::array<Vector3, 4>& p) {
  const SegmentPair nearest = closestPoints(p[0], p[1], p[2], p[3]);
  const Real s = alongEdge(nearest.pointA, p[0], p[1]);
  const Real t = alongEdge(nearest.pointB, p[2], p[3]);
  return {1 - s, s, 1 - t, t};
}

// Point, normal and gap at the time of the hit.
void describeContact(FeaturePair pair, const MovingPoints& points, FeatureImpact& result) {
  const bool face = pair == FeaturePair::kVertexFace;
  const std::array<Vector3, 4> places = placesAt(points, result.impact.time);
  result.weights = face ? weightsInFace(places) : weightsOnEdges(places);
  const std::size_t ofA = face ? 1 : 2;
  Vector3 pointA = Vector3::Zero(), pointB = pointA, before = pointA, velocity = pointA;
  for (std::size_t i = 0; i < 4; ++i) {
    const Real weight = result.weights[i], sign = i < ofA ? -1 : 1;
    (i < ofA ? pointA : pointB) += weight * places[i];
    before += sign * weight * points.start[i];
    velocity -= sign * weight * (points.end[i] - points.start[i]);
  }
  result.impact.point = pointB;
  result.impact.gap = (pointB - pointA).norm();

  // Square to the face, or to both edges; towards where B was at the start, seen from A.
  const Vector3 normal = face ? cross(places[2] - places[1], places[3] - places[1])
                              : cross(places[1] - places[0], places[3] - places[2]);
  const Real length = normal.norm();
  const Real towards = normal.dot(before);
  if (length > 0) {
    const bool flip = towards != 0 ? towards < 0 : normal.dot(velocity) < 0;
    result.impact.normal = (flip ? -1 : 1) * normal / length;
  } else if (velocity.norm() > 0) {
    result.impact.normal = velocity.normalized();
  }
}

FeatureImpact firstImpact(FeaturePair pair, const MovingPoints& points) {
  for (std::size_t i = 0; i < 4; ++i) {
    requireFinite(points.start[i], "start");
    requireFinite(points.end[i], "end");
  }
  FeatureImpact result;
  if (axisKeepsApart(pair, points)) return result;

  const Filtered filtered = filterContact(pair, points);
  if (filtered.verdict == FilterVerdict::kOpen) {
    result.decidedBy = DecidedBy::kExact;
    const std::optional<Real> time = exactFirstContact(pair, points);
    if (!time) return result;
    result.impact.time = *time;
  } else {
    result.decidedBy = DecidedBy::kFilter;
    if (filtered.verdict == FilterVerdict::kMiss) return result;
    result.decidedBy = filtered.neededExact ? DecidedBy::kExact : DecidedBy::kDoubleDouble;
    result.impact.time = filtered.time;
  }
  result.impact.status = ImpactStatus::kHit;
  describeContact(pair, points, result);
  return result;
}

}  // namespace

FeatureImpact vertexFaceImpact(const MovingPoints& points) {
  return firstImpact(FeaturePair::kVertexFace, points);
}

FeatureImpact edgeEdgeImpact(const MovingPoints& points) {
  return firstImpact(FeaturePair::kEdgeEdge, points);
}

}  // namespace carom
