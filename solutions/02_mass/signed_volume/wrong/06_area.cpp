#include "carom/mass/signed_volume.hpp"

#include "carom/core/cross.hpp"

namespace carom {

Real signedVolume(const TriangleMesh& mesh) {
  requireUsable(mesh);  // given: no triangles, bad indices and bad numbers are refused here

  Real sixVolumes = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    sixVolumes += cross(b - a, c - a).norm();
  }
  return sixVolumes / 6;
}

}  // namespace carom
