// Exercise 02.inertia_tensor: how much a solid resists being turned, about every axis at once.
// Check it with: ./course check 02.inertia_tensor

#include "carom/mass/inertia_tensor.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/todo.hpp"
#include "carom/mass/center_of_mass.hpp"

namespace carom {

Matrix3 inertiaTensor(const TriangleMesh& mesh, Real density) {
  requirePositive(density, "density");
  const Vector3 center = centerOfMass(mesh);  // given; refuses meshes that are not usable
  // First C, the sum of r rᵀ over the signed tetrahedra with the centre as fourth corner; a *
  // a.transpose() is a aᵀ. Then the tensor from C.
  static_cast<void>(center);
  return todo<Matrix3>("inertiaTensor");
}

}  // namespace carom
