// About a vertex of the body, and from there to the centre of mass.
#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

Matrix3 inertiaTensor(const TriangleMesh& mesh, Real density) {
  requirePositive(density, "density");
  const Vector3 o = mesh.vertices.empty() ? Vector3(0, 0, 0) : mesh.vertices[0];
  const Vector3 d = centerOfMass(mesh) - o;
  Matrix3 C = Matrix3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const Corners t = cornersOf(mesh, triangle);
    const Vector3 a = t.a - o, b = t.b - o, c = t.c - o, s = a + b + c;
    C += a.dot(cross(b, c)) / 120 *
         (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  C -= signedVolume(mesh) * d * d.transpose();
  return density * (C.trace() * Matrix3::Identity() - C);
}

}  // namespace carom
