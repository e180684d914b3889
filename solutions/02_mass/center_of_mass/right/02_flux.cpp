// The divergence theorem with the fields (x²/2, 0, 0), (0, y²/2, 0), (0, 0, z²/2).
#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

Vector3 centerOfMass(const TriangleMesh& mesh) {
  const Real volume = signedVolume(mesh);
  if (volume == 0) throw InvalidInput("no volume");
  const Vector3 o = mesh.vertices.front();
  Vector3 moment = Vector3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const auto [cornerA, cornerB, cornerC] = cornersOf(mesh, triangle);
    const Vector3 a = cornerA - o, b = cornerB - o, c = cornerC - o;
    const Vector3 area = cross(b - a, c - a) / 2;
    // The mean of x² over a triangle is (a² + b² + c² + (a + b + c)²) / 12.
    for (int k = 0; k < 3; ++k) {
      const Real s = a[k] + b[k] + c[k];
      moment[k] += area[k] * (a[k] * a[k] + b[k] * b[k] + c[k] * c[k] + s * s) / 24;
    }
  }
  return o + moment / volume;
}

}  // namespace carom
