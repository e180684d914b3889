#pragma once
// Another road to the best axis of two convex bodies.
//
// All differences b - a of their corners span a convex body; the bodies are apart exactly if the
// origin lies outside of it, and the best axis is square to the facet that is nearest to the origin
// or farthest from it. Here the facets are found by trying all pairs (in space: triples) of
// differences, which knows nothing of faces and edges, and is far too slow for anything else.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/real.hpp"

namespace carom::grading {

/// The largest gap that any axis shows.
struct BestGap {
  Real gap = -std::numeric_limits<Real>::infinity();     ///< negative: depth [m]
  Vector3 axis = Vector3::Zero();                        ///< unit, from A to B
  Real second = -std::numeric_limits<Real>::infinity();  ///< largest gap on any other axis [m]

  void offer(Real otherGap, const Vector3& otherAxis) {
    if ((otherAxis - axis).squaredNorm() < 1e-12) return;
    if (otherGap > gap) {
      second = gap;
      gap = otherGap;
      axis = otherAxis;
    } else if (otherGap > second) {
      second = otherGap;
    }
  }
  /// Whether the axis is the only one that comes near to it.
  bool isUnique() const {
    return gap - second > 1e-6;
  }
};

/// Planar figures, corners in any order. Each axis is tried both ways round.
inline BestGap bestGap(std::span<const Vector2> a, std::span<const Vector2> b) {
  std::vector<Vector2> d;
  for (const Vector2& p : a) {
    for (const Vector2& q : b) d.push_back(q - p);
  }
  BestGap best;
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = 0; j < d.size(); ++j) {
      const Vector2 side = d[j] - d[i];
      const Real length = side.norm();
      if (length < 1e-9) continue;
      const Vector2 outward(side.y() / length, -side.x() / length);
      const Real height = outward.dot(d[i]);
      bool facet = true;
      Real lowest = height;
      for (const Vector2& p : d) {
        facet = facet && outward.dot(p) <= height + 1e-9;
        lowest = std::min(lowest, outward.dot(p));
      }
      if (!facet) continue;
      best.offer(-height, {-outward.x(), -outward.y(), 0});
      best.offer(lowest, {outward.x(), outward.y(), 0});
    }
  }
  return best;
}

/// Solids, corners in any order. The gap is the largest of all axes if it is negative. If they are
/// apart it is positive, but then other axes may show a larger one.
inline BestGap bestGap(std::span<const Vector3> a, std::span<const Vector3> b) {
  std::vector<Vector3> d;
  for (const Vector3& p : a) {
    for (const Vector3& q : b) d.push_back(q - p);
  }
  BestGap best;
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = i + 1; j < d.size(); ++j) {
      for (std::size_t k = j + 1; k < d.size(); ++k) {
        const Vector3 across = cross(d[j] - d[i], d[k] - d[i]);
        const Real length = across.norm();
        if (length < 1e-6) continue;
        const Vector3 normal = across / length;
        const Real height = normal.dot(d[i]);
        bool above = false, below = false;
        for (std::size_t n = 0; n < d.size() && !(above && below); ++n) {
          const Real over = normal.dot(d[n]) - height;
          above = above || over > 1e-9;
          below = below || over < -1e-9;
        }
        if (!above) best.offer(-height, -normal);
        if (!below) best.offer(height, normal);
      }
    }
  }
  return best;
}

}  // namespace carom::grading
