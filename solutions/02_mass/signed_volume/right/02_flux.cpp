// The divergence theorem with the field (x, 0, 0): the mean x of a triangle times its area seen
// along x.
#include "carom/core/cross.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

Real signedVolume(const TriangleMesh& mesh) {
  requireUsable(mesh);
  const Real x0 = mesh.vertices.front().x();
  Real volume = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    const Real area = cross(b - a, c - a).x() / 2;
    volume += area * ((a.x() - x0) + (b.x() - x0) + (c.x() - x0)) / 3;
  }
  return volume;
}

}  // namespace carom
