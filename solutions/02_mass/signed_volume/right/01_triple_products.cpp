// Three edges from the fixed point, and the determinant written out.
#include "carom/mass/signed_volume.hpp"

namespace carom {

Real signedVolume(const TriangleMesh& mesh) {
  requireUsable(mesh);
  const Vector3 o = mesh.vertices[static_cast<std::size_t>(mesh.triangles[0][0])];
  Real volume = 0;
  for (const auto& triangle : mesh.triangles) {
    const Corners corners = cornersOf(mesh, triangle);
    const Vector3 p = corners.a - o;
    const Vector3 q = corners.b - o;
    const Vector3 r = corners.c - o;
    volume += (p.x() * (q.y() * r.z() - q.z() * r.y()) + p.y() * (q.z() * r.x() - q.x() * r.z()) +
               p.z() * (q.x() * r.y() - q.y() * r.x())) /
              6;
  }
  return volume;
}

}  // namespace carom
