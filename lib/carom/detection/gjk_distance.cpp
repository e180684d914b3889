#include "carom/detection/gjk_distance.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/detection/simplex.hpp"
#include "carom/detection/support_point.hpp"

namespace carom {

PointDistance gjkDistance(std::span<const Vector3> a, std::span<const Vector3> b) {
  for (const Vector3& point : a) requireFinite(point, "corner of A");
  for (const Vector3& point : b) requireFinite(point, "corner of B");

  PointDistance result;
  Simplex<3> simplex;
  Simplex<3> best;
  Real bestSquared = std::numeric_limits<Real>::infinity();
  Vector3 nearest = Vector3::UnitX();  // any direction will do to begin with
  while (true) {
    // The difference that lies farthest towards the origin: far in A against `nearest`, in B
    // along it.
    const Vector3 p = a[supportPoint(a, -nearest)];
    const Vector3 q = b[supportPoint(b, nearest)];
    simplex.vertices[static_cast<std::size_t>(simplex.count++)] = {p - q, p, q, -1, -1};
    ++result.iterations;

    nearest = closestToOrigin(simplex);
    // No nearer than before: what could be reached has been reached.
    if (!(nearest.squaredNorm() < bestSquared)) break;
    best = simplex;
    bestSquared = nearest.squaredNorm();
    // The origin is in the simplex: the bodies have a common point.
    if (simplex.count == 4 || bestSquared == 0) break;
  }
  result.distance = std::sqrt(bestSquared);
  witnessPoints(best, result.pointA, result.pointB);
  return result;
}

}  // namespace carom
