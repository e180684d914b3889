// Six integrals one by one, about the first vertex, then taken to the centre.
#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/inertia_tensor.hpp"

namespace carom {

Matrix3 inertiaTensor(const TriangleMesh& mesh, Real density) {
  requirePositive(density, "density");
  const Vector3 o = centerOfMass(mesh);
  Real xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;
  for (const auto& triangle : mesh.triangles) {
    const Corners t = cornersOf(mesh, triangle);
    const Vector3 p[3] = {t.a - o, t.b - o, t.c - o};
    const Real v = p[0].dot(cross(p[1], p[2])) / 6;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Real w = (i == j ? 2 : 1) * v / 20;
        xx += w * p[i].x() * p[j].x();
        yy += w * p[i].y() * p[j].y();
        zz += w * p[i].z() * p[j].z();
        xy += w * p[i].x() * p[j].y();
        yz += w * p[i].y() * p[j].z();
        zx += w * p[i].z() * p[j].x();
      }
    }
  }
  Matrix3 I;
  I << yy + zz, -xy, -zx, -xy, xx + zz, -yz, -zx, -yz, xx + yy;
  return density * I;
}

}  // namespace carom
