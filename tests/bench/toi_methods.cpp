#include "bench/toi_methods.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/detection/segment_segment.hpp"

namespace carom::bench {
namespace {

using Places = std::array<Vector3, 4>;

// c0 + c1 t + c2 t^2 + c3 t^3 of the four points.
std::array<Real, 4> coplanarity(FeaturePair pair, const MovingPoints& points) {
  const SeenFrom seen = seenFrom(pair);
  std::array<LinearVector<Real>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 start = points.start[seen.points[i]] - points.start[seen.origin];
    const Vector3 end = points.end[seen.points[i]] - points.end[seen.origin];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      corners[i].first[k] = start[row], corners[i].second[k] = end[row] - start[row];
    }
  }
  std::array<Quadratic<Real>, 3> bc;
  for (std::size_t k = 0; k < 3; ++k) bc[k] = crossComponent(corners[1], corners[2], k);
  return dotProduct(corners[0], bc);
}

// Roots between 0 and 1 in rising order: between the turning points the cubic is monotone.
std::vector<Real> rootsOf(const std::array<Real, 4>& c) {
  const auto value = [&](Real t) { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; };
  std::vector<Real> ends = {0, 1};
  const Real a = 3 * c[3], b = 2 * c[2], d = b * b - 4 * a * c[1];
  if (a != 0 && d >= 0) {
    for (const Real sign : {-1, 1}) ends.push_back((-b + sign * std::sqrt(d)) / (2 * a));
  } else if (a == 0 && b != 0) {
    ends.push_back(-c[1] / b);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<Real> roots;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    Real lo = ends[i], hi = ends[i + 1];
    if (lo < 0 || hi > 1 || value(lo) * value(hi) > 0) continue;
    if (value(lo) == 0 && value(hi) == 0) continue;
    const bool rises = value(lo) < value(hi);
    for (int k = 0; k < 60; ++k) {
      const Real middle = (lo + hi) / 2;
      ((value(middle) < 0) == rises ? lo : hi) = middle;
    }
    roots.push_back((lo + hi) / 2);
  }
  return roots;
}

bool isInside(FeaturePair pair, const Places& p, Real tolerance) {
  const auto isShare = [tolerance](Real s) { return s >= -tolerance && s <= 1 + tolerance; };
  if (pair == FeaturePair::kVertexFace) {
    const Vector3 n = cross(p[2] - p[1], p[3] - p[1]);
    const Real area = n.squaredNorm();
    return isShare(cross(p[2] - p[0], p[3] - p[0]).dot(n) / area) &&
           isShare(cross(p[3] - p[0], p[1] - p[0]).dot(n) / area) &&
           isShare(cross(p[1] - p[0], p[2] - p[0]).dot(n) / area);
  }
  const Vector3 e = p[1] - p[0], f = p[3] - p[2], n = cross(e, f);
  return isShare(cross(p[2] - p[0], f).dot(n) / n.squaredNorm()) &&
         isShare(cross(p[2] - p[0], e).dot(n) / n.squaredNorm());
}

Real distanceAt(FeaturePair pair, const Places& p) {
  if (pair == FeaturePair::kVertexFace) {
    return (closestOnTriangle(p[0], p[1], p[2], p[3]) - p[0]).norm();
  }
  return std::sqrt(closestPoints(p[0], p[1], p[2], p[3]).squared);
}

}  // namespace

std::optional<Real> cubicWithTolerance(FeaturePair pair, const MovingPoints& points,
                                       Real tolerance) {
  for (const Real t : rootsOf(coplanarity(pair, points))) {
    if (isInside(pair, placesAt(points, t), tolerance)) return t;
  }
  return std::nullopt;
}

std::optional<Real> advanceFeatures(FeaturePair pair, const MovingPoints& points, Real tolerance,
                                    int limit) {
  // No two points of the features approach each other faster than two of their corners.
  const std::size_t ofA = pair == FeaturePair::kVertexFace ? 1 : 2;
  Real speed = 0;
  for (std::size_t i = 0; i < ofA; ++i) {
    for (std::size_t j = ofA; j < 4; ++j) {
      const Vector3 relative =
          (points.end[i] - points.start[i]) - (points.end[j] - points.start[j]);
      speed = std::max(speed, relative.norm());
    }
  }
  Real t = 0;
  for (int i = 0; i < limit; ++i) {
    const Real gap = distanceAt(pair, placesAt(points, t));
    if (gap <= tolerance) return t;
    if (gap > speed * (1 - t)) return std::nullopt;
    t += gap / speed * (1 - 1e-12);
  }
  return t;
}

}  // namespace carom::bench
