#include "carom/mass/center_of_mass.hpp"

#include "carom/core/errors.hpp"
#include "carom/mass/signed_volume.hpp"

namespace carom {

Vector3 centerOfMass(const TriangleMesh& mesh) {
  requireUsable(mesh);
  if (signedVolume(mesh) == 0) throw InvalidInput("centerOfMass: the mesh encloses no volume");
  Vector3 sum = Vector3::Zero();
  for (const Vector3& vertex : mesh.vertices) sum += vertex;
  return sum / static_cast<Real>(mesh.vertices.size());
}

}  // namespace carom
