#include "carom/mass/inertia_tensor.hpp"

#include <cmath>
#include <string>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/mass/center_of_mass.hpp"

namespace carom {

Matrix3 inertiaTensor(const TriangleMesh& mesh, Real density) {
  if (!(density > 0) || !std::isfinite(density)) {
    throw InvalidInput("inertiaTensor: density must be positive, but is " +
                       std::to_string(density));
  }
  const Vector3 center = centerOfMass(mesh);  // refuses meshes that are not usable

  // Second moments C = ∫ r rᵀ dV about the centre of mass.
  Matrix3 C = Matrix3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const auto [cornerA, cornerB, cornerC] = cornersOf(mesh, triangle);
    const Vector3 a = cornerA - center;
    const Vector3 b = cornerB - center;
    const Vector3 c = cornerC - center;
    const Vector3 s = a + b + c;
    const Real sixV = a.dot(cross(cornerB - cornerA, cornerC - cornerA));
    C += sixV * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  C /= 120;  // 6 for the determinant, 20 for the moments of a tetrahedron

  // Mass far from an axis counts: I_xx = ∫ (y² + z²), and the products enter with a minus sign.
  return density * (C.trace() * Matrix3::Identity() - C);
}

}  // namespace carom
