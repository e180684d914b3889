#pragma once
// Is this mesh the skin of a solid at all?
//
// Method: look at vertices and indices first, then at each triangle, then at edges: in a closed
// skin whose triangles all look outwards, two neighbours run along their common edge in opposite
// directions, so every directed edge occurs once and its reverse once. Last, the volume must be
// positive, and if the skin is in several pieces, each piece must look to the right side.
// Why first: the volume integral gives a number for every input, right or not. An open mesh gives
// another number for every choice of origin, a flipped one a negative mass, and both would only be
// noticed much later, as a body that accelerates against the force.
// Source: Mäntylä 1988 on manifold surfaces. Each stage runs only if the stages before it found
// nothing, since their problems would show up again as others.
// Not handled: surfaces that cut themselves (self_intersections.hpp). A good mesh is recognised ten
// times faster by quick_mesh_check.hpp.

#include <vector>

#include "carom/mass/mesh_problem.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// Looks for everything that would make the volume integrals meaningless.
/// \param mesh any mesh, however broken
/// \return the problems found, empty for a good mesh; at most kMaxMeshProblems, in ascending order
/// of triangles or edges
/// \ingroup mass
std::vector<MeshProblem> checkMesh(const TriangleMesh& mesh);

}  // namespace carom
