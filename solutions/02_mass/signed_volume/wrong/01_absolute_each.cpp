#include "carom/mass/signed_volume.hpp"

#include <cmath>

#include "carom/core/cross.hpp"

namespace carom {

Real signedVolume(const TriangleMesh& mesh) {
  requireUsable(mesh);  // given: no triangles, bad indices and bad numbers are refused here

  const Vector3 origin = Vector3::Zero();
  Real sixVolumes = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    sixVolumes += std::abs((a - origin).dot(cross(b - a, c - a)));
  }
  return sixVolumes / 6;
}

}  // namespace carom
