#pragma once
// How large is the solid inside a mesh?
//
// Method: every triangle (a, b, c) spans a tetrahedron with one fixed point; its volume is a
// determinant over six, positive if the triangle looks away from the point and negative if it looks
// towards it. What lies outside the solid is counted as often positive as negative, so the sum is
// the volume.
// Why: exact for polyhedra, a dozen operations per triangle, no need to cut the solid into
// tetrahedra first.
// Source: divergence theorem; Mirtich 1996; the source text's method 1.
// Not handled: a mesh that is not closed has no volume, and the sum then depends on the fixed
// point.

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// The volume inside a closed mesh: positive if its triangles look outwards, negative if they look
/// inwards.
/// \param mesh a closed surface [m]
/// \return signed volume [m^3]
/// \throws InvalidInput if the mesh has no triangles, a bad index or a coordinate that is not
/// finite
/// \erratum{3.3} \ingroup mass
Real signedVolume(const TriangleMesh& mesh);

}  // namespace carom
