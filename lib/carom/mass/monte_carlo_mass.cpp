#include "carom/mass/monte_carlo_mass.hpp"

#include <cmath>
#include <string>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"

namespace carom {
namespace {

// Twice the signed area of the triangle (p, q, r) seen from above.
Real areaFromAbove(const Vector3& p, const Vector3& q, const Vector3& r) {
  return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
}

// How often a ray from p straight up leaves the solid minus how often it enters: 1 inside, 0
// outside.
int windingNumber(const TriangleMesh& mesh, const Vector3& p) {
  int winding = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    // Weights of a, b, c: all of one sign if the vertical line through p goes through the triangle.
    const Real u = areaFromAbove(p, b, c);
    const Real v = areaFromAbove(p, c, a);
    const Real w = areaFromAbove(p, a, b);
    const bool outwards = u > 0 && v > 0 && w > 0;
    const bool inwards = u < 0 && v < 0 && w < 0;
    if (!outwards && !inwards) continue;
    const Real height = (u * a.z() + v * b.z() + w * c.z()) / (u + v + w);
    if (height > p.z()) winding += outwards ? 1 : -1;
  }
  return winding;
}

}  // namespace

MonteCarloMass monteCarloMass(const TriangleMesh& mesh, Real density, int samples,
                              std::uint64_t seed) {
  requireUsable(mesh);
  if (samples <= 0 || !(density > 0) || !std::isfinite(density)) {
    throw InvalidInput("monteCarloMass: samples and density must be positive, but are " +
                       std::to_string(samples) + " and " + std::to_string(density));
  }
  Vector3 low = mesh.vertices.front();
  Vector3 high = low;
  for (const Vector3& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }

  // Throw the darts; r is measured from the middle of the box, so that no digits are lost far from
  // the origin.
  const Vector3 middle = (low + high) / 2;
  Random random(seed);
  int inside = 0;
  Vector3 sum = Vector3::Zero();      // of r
  Matrix3 squares = Matrix3::Zero();  // of r rᵀ
  for (int i = 0; i < samples; ++i) {
    Vector3 p;
    for (int k = 0; k < 3; ++k) p[k] = random.between(low[k], high[k]);
    if (windingNumber(mesh, p) == 0) continue;
    const Vector3 r = p - middle;
    ++inside;
    sum += r;
    squares += r * r.transpose();
  }

  MonteCarloMass estimate;
  estimate.samples = samples;
  estimate.inside = inside;
  if (inside == 0) return estimate;

  // Volume: the share of hits, times the volume of the box that was thrown at.
  const Real share = static_cast<Real>(inside) / samples;
  const Vector3 size = high - low;
  MassProperties& body = estimate.body;
  body.volume = share * size.x() * size.y() * size.z();
  body.mass = density * body.volume;

  // Every hit stands for an equal part of the mass; second moments are taken about the mean.
  const Vector3 mean = sum / inside;
  const Matrix3 C = body.mass * (squares / inside - mean * mean.transpose());
  body.center = middle + mean;
  body.inertia = C.trace() * Matrix3::Identity() - C;
  estimate.relativeError = std::sqrt((1 - share) / (share * samples));
  return estimate;
}

}  // namespace carom
