#pragma once
// How large is a mesh, and where?
//
// Method: the least and the largest coordinate along each axis.
// Why: it gives the sums over tetrahedra an origin near the mesh, and says whether a solid is thin.
// Source: none needed.
// Not handled: vertices that no triangle uses count too; NaNs are passed over.

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// The box along the axes around a mesh. \ingroup mass
struct MeshBounds {
  Vector3 low = Vector3::Zero();   ///< least coordinates [m, frame of the mesh]
  Vector3 high = Vector3::Zero();  ///< largest coordinates [m, frame of the mesh]
};

/// The smallest box along the axes that holds all vertices.
/// \param mesh with at least one vertex [m]
/// \return the box
/// \throws InvalidInput if there are no vertices
/// \ingroup mass
MeshBounds boundsOf(const TriangleMesh& mesh);

}  // namespace carom
