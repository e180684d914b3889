// Looks first whether the next corner can help at all, and also ends when a corner comes back.
#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/detection/gjk_distance.hpp"
#include "carom/detection/simplex.hpp"
#include "carom/detection/support_point.hpp"

namespace carom {

PointDistance gjkDistance(std::span<const Vector3> a, std::span<const Vector3> b) {
  if (a.empty() || b.empty()) throw InvalidInput("a body has no corners");
  for (const Vector3& p : a) requireFinite(p, "corner of A");
  for (const Vector3& q : b) requireFinite(q, "corner of B");
  Simplex<3> simplex;
  simplex.vertices[0] = {a[0] - b[0], a[0], b[0], 0, 0};
  simplex.count = 1;
  Vector3 v = closestToOrigin(simplex);
  PointDistance result;
  for (;;) {
    result.distance = v.norm();
    witnessPoints(simplex, result.pointA, result.pointB);
    if (simplex.count == 4 || result.distance == 0) return result;
    ++result.iterations;
    const std::size_t i = supportPoint(a, -v);
    const std::size_t j = supportPoint(b, v);
    const Vector3 w = a[i] - b[j];
    bool known = false;
    for (int k = 0; k < simplex.count; ++k) {
      known = known || simplex.vertices[static_cast<std::size_t>(k)].difference == w;
    }
    if (known || v.dot(v - w) <= 0) return result;
    Simplex<3> next = simplex;
    next.vertices[static_cast<std::size_t>(next.count++)] = {w, a[i], b[j], 0, 0};
    const Vector3 nearer = closestToOrigin(next);
    if (!(nearer.norm() < v.norm())) return result;
    simplex = next;
    v = nearer;
  }
}

}  // namespace carom
