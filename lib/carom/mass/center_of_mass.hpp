#pragma once
// Where does a solid balance?
//
// Method: the mean of the centres of the signed tetrahedra (see signed_volume.hpp), weighted by
// their signed volumes. The centre of a tetrahedron is the mean of its four corners.
// Why: exact, and the same pass as the volume. The mean of the vertices follows how finely a side
// happens to be meshed, and the mean of the triangles is the centre of the skin
// (shell_centroid.hpp).
// Source: Tonon 2004; Nürnberg's note on the centroid of a polyhedron.
// Not handled: a mesh without volume has no centre of mass.

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// The centre of mass of the solid inside a closed mesh of constant density. The same for a mesh
/// turned inside out.
/// \param mesh a closed surface [m]
/// \return centre of mass [m, frame of the mesh]
/// \throws InvalidInput if the mesh is unusable (requireUsable()) or its volume is zero
/// \erratum{3.5}
/// \ingroup mass
Vector3 centerOfMass(const TriangleMesh& mesh);

}  // namespace carom
