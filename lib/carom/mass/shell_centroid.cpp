#include "carom/mass/shell_centroid.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"

namespace carom {

Vector3 shellCentroid(const TriangleMesh& mesh) {
  requireUsable(mesh);

  const Vector3 origin = mesh.vertices.front();
  Real twoAreas = 0;
  Vector3 moment = Vector3::Zero();  // sum of 2 A times 3 centres
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    const Real twoA = cross(b - a, c - a).norm();
    moment += twoA * ((a - origin) + (b - origin) + (c - origin));
    twoAreas += twoA;
  }
  if (twoAreas == 0) throw InvalidInput("shellCentroid: the mesh has no area");
  return origin + moment / (3 * twoAreas);
}

Real surfaceArea(const TriangleMesh& mesh) {
  requireUsable(mesh);
  Real twoAreas = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    twoAreas += cross(b - a, c - a).norm();
  }
  return twoAreas / 2;
}

}  // namespace carom
