#pragma once
// A solid as its skin: vertices, and triangles that name three vertices each.
//
// A closed skin is enough to weigh a solid: by the divergence theorem every integral over the
// inside is a sum over the triangles, so no cutting into tetrahedra is needed. Triangles are the
// common language of mesh files and of drawing; collision detection prefers balls, boxes, capsules
// and hulls (chapter 3).
//
// Not handled here: whether the skin is closed and looks outwards. check_mesh.hpp judges that.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "carom/core/real.hpp"

/// \defgroup mass Mass properties: chapter 2
/// Volume, centre of mass and inertia of solids.

namespace carom {

/// A closed surface made of triangles. Seen from outside, the corners of a triangle run
/// counter-clockwise, so that its normal points out of the solid. Plain data: checkMesh() says
/// whether it is what it should be.
/// \erratum{3.2} \ingroup mass
struct TriangleMesh {
  std::vector<Vector3> vertices;                       ///< corners [m, frame of the mesh]
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< indices into vertices
};

/// The three corners of a triangle, counter-clockwise seen from outside.
/// \ingroup mass
struct Corners {
  Vector3 a;  ///< first corner [m, frame of the mesh]
  Vector3 b;  ///< second corner [m, frame of the mesh]
  Vector3 c;  ///< third corner [m, frame of the mesh]
};

/// The corners of one triangle of a mesh. The indices are trusted: call requireUsable() once before
/// a loop.
/// \param mesh the mesh
/// \param triangle three indices into mesh.vertices
/// \return the corners in the order of the indices [m, frame of the mesh]
/// \ingroup mass
inline Corners cornersOf(const TriangleMesh& mesh, const std::array<std::int32_t, 3>& triangle) {
  return {mesh.vertices[static_cast<std::size_t>(triangle[0])],
          mesh.vertices[static_cast<std::size_t>(triangle[1])],
          mesh.vertices[static_cast<std::size_t>(triangle[2])]};
}

/// Refuses a mesh that cannot even be looped over: no triangles, an index that names no vertex, or
/// a coordinate that is not a finite number. Says nothing about whether the mesh is closed
/// (checkMesh() does).
/// \param mesh the mesh to look at
/// \throws InvalidInput naming the first triangle or vertex that is wrong
/// \ingroup mass
void requireUsable(const TriangleMesh& mesh);

}  // namespace carom
