// Exercise 03.gjk_distance: how far apart are two bodies of which only the corners are known?
// Check it with: ./course check 03.gjk_distance

#include "carom/detection/gjk_distance.hpp"

#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"
#include "carom/detection/simplex.hpp"
#include "carom/detection/support_point.hpp"

namespace carom {
namespace {

[[maybe_unused]] void add(Simplex<3>& simplex, const Vector3& cornerA, const Vector3& cornerB) {
  simplex.vertices[static_cast<std::size_t>(simplex.count++)] = {cornerA - cornerB, cornerA,
                                                                 cornerB, -1, -1};
}

}  // namespace

PointDistance gjkDistance(std::span<const Vector3> a, std::span<const Vector3> b) {
  if (a.empty() || b.empty()) throw InvalidInput("gjkDistance: a body must have a corner");
  for (const Vector3& point : a) requireFinite(point, "corner of A");
  for (const Vector3& point : b) requireFinite(point, "corner of B");

  PointDistance result;
  Simplex<3> simplex;
  Simplex<3> best;
  Real bestSquared = std::numeric_limits<Real>::infinity();
  Vector3 nearest = Vector3::UnitX();  // any direction will do to begin with
  while (true) {
    const Vector3 p = a[supportPoint(a, -nearest)];
    const Vector3 q = b[supportPoint(b, nearest)];
    add(simplex, p, q);
    ++result.iterations;

    nearest = closestToOrigin(simplex);
    // No nearer than before: what could be reached has been reached.
    if (!(nearest.norm() < std::sqrt(bestSquared) - 1e-5)) break;
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
