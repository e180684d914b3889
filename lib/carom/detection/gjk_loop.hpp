#pragma once
// The loop of GJK, in the plane and in space, as the library uses it.
//
// Method: as gjkDistance(), with two refinements that matter when bodies nearly touch. The search
// direction of a triangle is its own normal, which is right to an ulp, and not the nearest point,
// whose direction is noise once its length is near the rounding error of its coordinates. And the
// loop ends by either of two exact signs of no progress: the new support point reaches no farther
// along the search direction than the simplex does already, or it brings nothing nearer.
// Why no tolerance: see ACM TOG 36 (2017), Montanari et al., and the issues about tolerances in
// FCL, Coal and libccd: too small a one never ends, too large a one is wrong for small gaps.
// Not handled: the depth of overlaps (expanding_polytope.hpp).

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/core/real.hpp"
#include "carom/detection/simplex.hpp"

namespace carom::detail {

/// How the loop ended. \ingroup detection
enum class GjkEnd {
  apart,    ///< a plane between the bodies was found
  unclear,  ///< the origin is in the simplex, or so near that rounding decides
  stalled,  ///< out of steps
};

/// What the loop knows at its end. \tparam Dim 2 or 3 \ingroup detection
template <int Dim>
struct GjkResult {
  using Vector = Eigen::Matrix<Real, Dim, 1>;  ///< a column of Dim numbers
  GjkEnd end = GjkEnd::unclear;                ///< how it ended
  Vector direction = Vector::Zero();           ///< unit, from A to B, if apart [1]
  Real upper = 0;                              ///< distance of the nearest points found [m]
  Real lower = 0;                              ///< distance along direction, proven [m]
  int iterations = 0;                          ///< support points asked for
};

/// More steps than polyhedra have been seen to need in a million pairs (boxes 12, hulls 30); cylinders
/// come to their last digits in 20 to 100, and a few of them are stopped there. \ingroup detection
inline constexpr int kMostGjkSteps = 128;

/// The direction in which a simplex of two corners in the plane, or three in space, faces the
/// origin; false if it is too flat to tell better than its nearest point.
inline bool facing(const Simplex<2>& simplex, const Vector2& nearest, Vector2& d) {
  if (simplex.count != 2) return false;
  const Vector2& a = simplex.vertices[0].difference;
  const Vector2 edge = simplex.vertices[1].difference - a;
  d = {edge.y(), -edge.x()};
  if (d.dot(nearest) > 0) d = -d;
  return true;
}

/// \copydoc facing
inline bool facing(const Simplex<3>& simplex, const Vector3& nearest, Vector3& d) {
  if (simplex.count == 2) {
    // Square to the edge: what the nearest point leans along it is rounding.
    const Vector3 edge = simplex.vertices[1].difference - simplex.vertices[0].difference;
    d = (nearest.dot(edge) / edge.squaredNorm()) * edge - nearest;
    return true;
  }
  if (simplex.count != 3) return false;
  const Vector3& a = simplex.vertices[0].difference;
  const Vector3 u = simplex.vertices[1].difference - a, v = simplex.vertices[2].difference - a;
  d = cross(u, v);
  // Both are as good as the rounding of the coordinates over a length: the triangle's smallest
  // height here, the length of the nearest point there. On curved bodies the triangles get tiny.
  const Real squared = d.squaredNorm();
  const Real longest = std::max(u.squaredNorm(), v.squaredNorm());
  if (!(squared > longest * nearest.squaredNorm())) return false;
  if (d.dot(nearest) > 0) d = -d;
  return squared > 0;
}

/// Runs GJK. \tparam Dim 2 or 3 \tparam SupportFunction Vector -> SimplexVertex<Dim>
/// \param support farthest point of A - B in a direction
/// \param simplex in: empty or corners to start with; out: the corners that hold the nearest point
/// \param start where to look first if the simplex is empty, from B to A
/// \param size largest length of coordinates that meet, for the rounding error [m]
/// \return what was found
template <int Dim, class SupportFunction>
GjkResult<Dim> runGjk(const SupportFunction& support, Simplex<Dim>& simplex,
                      const Eigen::Matrix<Real, Dim, 1>& start, Real size) {
  using Vector = Eigen::Matrix<Real, Dim, 1>;
  GjkResult<Dim> result;
  // The rounding error of a difference of two points: three products and sums each, half an ulp.
  const Real noise = 8 * std::numeric_limits<Real>::epsilon() * size;
  if (simplex.count == 0) {
    simplex.vertices[0] = support(-start);
    simplex.count = 1;
    ++result.iterations;
  }
  NearestPoint<Dim> nearest, next;
  nearestToOrigin(simplex, nearest);
  keepOnly(simplex, nearest);
  while (true) {
    if (simplex.count == Dim + 1 || nearest.squared <= noise * noise) return result;  // unclear

    Vector d;
    if (!facing(simplex, nearest.point, d)) d = -nearest.point;
    const SimplexVertex<Dim> fresh = support(d);
    ++result.iterations;

    // How far the simplex reaches along d, and how far the bodies do.
    Real reach = -std::numeric_limits<Real>::infinity();
    bool known = false;
    for (int i = 0; i < simplex.count; ++i) {
      const SimplexVertex<Dim>& old = simplex.vertices[static_cast<std::size_t>(i)];
      reach = std::max(reach, d.dot(old.difference));
      known |= old.idA == fresh.idA && old.idB == fresh.idB && (old.idA | old.idB) >= 0;
    }
    const Real farther = d.dot(fresh.difference);
    bool better = !known && farther > reach;
    if (better) {
      simplex.vertices[static_cast<std::size_t>(simplex.count++)] = fresh;
      nearestToOrigin(simplex, next);
      better = next.squared < nearest.squared && result.iterations < kMostGjkSteps;
      if (better) {
        nearest = next;
        keepOnly(simplex, nearest);
        continue;
      }
      --simplex.count;
    }
    // No progress: the plane through the farthest point is the proof of the distance.
    const Real whole = d.norm();
    result.direction = d / whole;
    result.upper = std::sqrt(nearest.squared);
    result.lower = -std::max(farther, reach) / whole;
    result.end = result.lower > noise ? GjkEnd::apart : GjkEnd::unclear;
    if (result.iterations >= kMostGjkSteps) result.end = GjkEnd::stalled;
    return result;
  }
}

}  // namespace carom::detail
