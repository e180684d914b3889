#include "carom/mass/triangle_mesh.hpp"

#include <string>

#include "carom/core/errors.hpp"

namespace carom {

void requireUsable(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw InvalidInput("the mesh is empty: it has no triangles");
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!mesh.vertices[v].allFinite()) {
      throw InvalidInput("vertex " + std::to_string(v) + " has a coordinate that is not finite");
    }
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t index : mesh.triangles[t]) {
      if (index < 0 || static_cast<std::size_t>(index) >= mesh.vertices.size()) {
        throw InvalidInput("triangle " + std::to_string(t) + " names vertex " +
                           std::to_string(index) + ", but the mesh has vertices 0 to " +
                           std::to_string(static_cast<long long>(mesh.vertices.size()) - 1));
      }
    }
  }
}

}  // namespace carom
