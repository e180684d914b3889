#include "carom/mass/mesh_bounds.hpp"

#include "carom/core/errors.hpp"

namespace carom {

MeshBounds boundsOf(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) throw InvalidInput("boundsOf: the mesh has no vertices");

  // Six plain numbers stay in registers; six entries of two vectors went through memory, at half
  // the speed.
  const Vector3& first = mesh.vertices.front();
  Real lowX = first.x(), lowY = first.y(), lowZ = first.z();
  Real highX = lowX, highY = lowY, highZ = lowZ;
  for (const Vector3& vertex : mesh.vertices) {
    const Real x = vertex.x(), y = vertex.y(), z = vertex.z();
    lowX = x < lowX ? x : lowX;
    lowY = y < lowY ? y : lowY;
    lowZ = z < lowZ ? z : lowZ;
    highX = x > highX ? x : highX;
    highY = y > highY ? y : highY;
    highZ = z > highZ ? z : highZ;
  }
  return {{lowX, lowY, lowZ}, {highX, highY, highZ}};
}

}  // namespace carom
