// Volume and centre of every tetrahedron, spelled out.
#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/mass/center_of_mass.hpp"

namespace carom {

Vector3 centerOfMass(const TriangleMesh& mesh) {
  requireUsable(mesh);
  const Vector3 o = cornersOf(mesh, mesh.triangles.back()).c;
  Real volume = 0;
  Vector3 sum = Vector3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const Corners t = cornersOf(mesh, triangle);
    const Vector3 p = t.a - o, q = t.b - o, r = t.c - o;
    const Real v = p.dot(cross(q, r)) / 6;
    const Vector3 center = (Vector3::Zero() + p + q + r) / 4;
    sum += v * center;
    volume += v;
  }
  if (volume == 0) throw InvalidInput("there is no volume, so there is no centre of mass");
  return sum / volume + o;
}

}  // namespace carom
