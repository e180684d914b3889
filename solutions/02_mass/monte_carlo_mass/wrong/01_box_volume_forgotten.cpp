#include "carom/mass/monte_carlo_mass.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/random.hpp"

namespace carom {
namespace {

Real areaFromAbove(const Vector3& p, const Vector3& q, const Vector3& r) {
  return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
}

bool isInside(const TriangleMesh& mesh, const Vector3& p) {
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
  Vector3 low = mesh.vertices.front();
  Vector3 high = low;
  for (const Vector3& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }

  const Vector3 middle = (low + high) / 2;
  Random random(seed);
  int inside = 0;
  Vector3 sum = Vector3::Zero();      // of r
  Matrix3 squares = Matrix3::Zero();  // of r rᵀ
  for (int i = 0; i < samples; ++i) {
    Vector3 p;
    for (int k = 0; k < 3; ++k) p[k] = random.between(low[k], high[k]);
    if (!isInside(mesh, p)) continue;
    const Vector3 r = p - middle;
    ++inside;
    sum += r;
    squares += r * r.transpose();
  }

  MonteCarloMass estimate;
  estimate.samples = samples;
  estimate.inside = inside;
  if (inside == 0) return estimate;

  const Real share = static_cast<Real>(inside) / samples;
  estimate.body.volume = share;
  estimate.body.mass = density * estimate.body.volume;

  const Vector3 mean = sum / inside;
  const Matrix3 C = estimate.body.mass * (squares / inside - mean * mean.transpose());
  estimate.body.center = middle + mean;
  estimate.body.inertia = C.trace() * Matrix3::Identity() - C;
  estimate.relativeError = std::sqrt((1 - share) / (share * samples));
  return estimate;
}

}  // namespace carom
