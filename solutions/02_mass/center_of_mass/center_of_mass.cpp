// Exercise 02.center_of_mass: where a solid balances.
// Check it with: ./course check 02.center_of_mass

#include "carom/mass/center_of_mass.hpp"

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Vector3 centerOfMass(const TriangleMesh& mesh) {
  requireUsable(mesh);  // given: no triangles, bad indices and bad numbers are refused here
  //# solution

  const Vector3 origin = mesh.vertices.front();
  Real sixVolumes = 0;
  Vector3 moment = Vector3::Zero();  // sum of 6 V times 4 centres
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    const Real sixV = (a - origin).dot(cross(b - a, c - a));
    // The fourth corner is the origin, so the mean of the corners is their sum over four.
    moment += sixV * ((a - origin) + (b - origin) + (c - origin));
    sixVolumes += sixV;
  }
  if (sixVolumes == 0) throw InvalidInput("centerOfMass: the mesh encloses no volume");
  return origin + moment / (4 * sixVolumes);
  //# stub
  // The tetrahedra of signed_volume once more. Where is the centre of one of them, and how much
  // does it count? A mesh without volume has no centre: throw InvalidInput("...").
  //#| return todo<Vector3>("centerOfMass");
  //# end
}

}  // namespace carom
