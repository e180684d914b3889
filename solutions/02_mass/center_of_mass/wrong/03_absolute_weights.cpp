#include "carom/mass/center_of_mass.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {

Vector3 centerOfMass(const TriangleMesh& mesh) {
  requireUsable(mesh);  // given: no triangles, bad indices and bad numbers are refused here

  const Vector3 origin = mesh.vertices.front();
  Real sixVolumes = 0;
  Vector3 moment = Vector3::Zero();  // sum of 6 V times 4 centres
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    const Real sixV = std::abs((a - origin).dot(cross(b - a, c - a)));
    moment += sixV * ((a - origin) + (b - origin) + (c - origin));
    sixVolumes += sixV;
  }
  if (sixVolumes == 0) throw InvalidInput("centerOfMass: the mesh encloses no volume");
  return origin + moment / (4 * sixVolumes);
}

}  // namespace carom
