// Exercise 02.monte_carlo_mass: weighing a solid by throwing darts.
// Check it with: ./course check 02.monte_carlo_mass

#include "carom/mass/monte_carlo_mass.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/random.hpp"
#include "carom/core/todo.hpp"

namespace carom {
namespace {

// Given: twice the signed area of the triangle (p, q, r) seen from above.
Real areaFromAbove(const Vector3& p, const Vector3& q, const Vector3& r) {
  return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
}

// Given: whether p is inside. A ray from p straight up leaves the solid once more often than it
// enters.
[[maybe_unused]] bool isInside(const TriangleMesh& mesh, const Vector3& p) {
  int leaves = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    const Real u = areaFromAbove(p, b, c);
    const Real v = areaFromAbove(p, c, a);
    const Real w = areaFromAbove(p, a, b);
    const bool outwards = u > 0 && v > 0 && w > 0;
    const bool inwards = u < 0 && v < 0 && w < 0;
    if (!outwards && !inwards) continue;
    const Real height = (u * a.z() + v * b.z() + w * c.z()) / (u + v + w);
    if (height > p.z()) leaves += outwards ? 1 : -1;
  }
  return leaves != 0;
}

}  // namespace

MonteCarloMass monteCarloMass(const TriangleMesh& mesh, Real density, int samples,
                              std::uint64_t seed) {
  requireUsable(mesh);
  requirePositive(density, "density");
  requirePositive(samples, "samples");
  // Given: the box around the mesh.
  Vector3 low = mesh.vertices.front();
  Vector3 high = low;
  for (const Vector3& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  // Random random(seed) makes numbers: random.between(low.x(), high.x()) is the next one in the
  // box. Count the hits, and add up p and p * p.transpose() for them.
  return todo<MonteCarloMass>("monteCarloMass");
}

}  // namespace carom
