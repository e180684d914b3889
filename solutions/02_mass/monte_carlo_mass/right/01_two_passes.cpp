// The hits are kept; centre first, then the moments about it.
#include <cmath>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/monte_carlo_mass.hpp"

namespace carom {
namespace {

// By the solid angle that each triangle fills in the eyes of p: 4 pi in all if p is inside.
bool isInside(const TriangleMesh& mesh, const Vector3& p) {
  Real angle = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [cornerA, cornerB, cornerC] = cornersOf(mesh, triangle);
    const Vector3 a = cornerA - p, b = cornerB - p, c = cornerC - p;
    const Real la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2 * std::atan2(a.dot(cross(b, c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle > 6;
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
  const Vector3 size = high - low;
  Random random(seed);
  std::vector<Vector3> hits;
  for (int i = 0; i < samples; ++i) {
    const Real z = random.between(0, 1), y = random.between(0, 1), x = random.between(0, 1);
    const Vector3 p = low + size.cwiseProduct(Vector3(x, y, z));
    if (isInside(mesh, p)) hits.push_back(p);
  }
  MonteCarloMass estimate;
  estimate.samples = samples;
  estimate.inside = static_cast<int>(hits.size());
  if (hits.empty()) return estimate;

  const Real p = static_cast<Real>(hits.size()) / samples;
  MassProperties& body = estimate.body;
  body.volume = p * size.x() * size.y() * size.z();
  body.mass = body.volume * density;
  for (const Vector3& hit : hits) body.center += hit / static_cast<Real>(hits.size());
  const Real part = body.mass / static_cast<Real>(hits.size());
  for (const Vector3& hit : hits) {
    const Vector3 r = hit - body.center;
    body.inertia += part * (r.squaredNorm() * Matrix3::Identity() - r * r.transpose());
  }
  estimate.relativeError = std::sqrt((1 - p) / (p * samples));
  return estimate;
}

}  // namespace carom
