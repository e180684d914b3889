#pragma once
// Where does a thin shell balance?
//
// Method: the mean of the triangles' centres weighted by their areas.
// Why: it is the centre of mass of the skin, of a hollow body of thin sheet. The source text offers
// it (method 3) as a fast centre of the solid, which it is not: for a half ball it gives 1/3 or 1/2
// of the radius instead of 3/8. It is in the library under its right name.
// Not handled: sheets of varying thickness.

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// The centre of mass of the surface of a mesh, taken as a thin sheet of even thickness. Not the
/// centre of mass of the solid inside (centerOfMass()). Open meshes are welcome.
/// \param mesh any surface [m]
/// \return centre of mass of the sheet [m, frame of the mesh]
/// \throws InvalidInput if the mesh is unusable (requireUsable()) or its area is zero
/// \erratum{3.5} \ingroup mass
Vector3 shellCentroid(const TriangleMesh& mesh);

/// The area of the surface of a mesh.
/// \param mesh any surface [m]
/// \return sum of the areas of its triangles [m^2]
/// \throws InvalidInput if the mesh is unusable (requireUsable())
/// \ingroup mass
Real surfaceArea(const TriangleMesh& mesh);

}  // namespace carom
