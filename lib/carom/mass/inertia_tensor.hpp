#pragma once
// How much does a solid resist being turned, about every axis at once?
//
// Method: sum over the signed tetrahedra with the centre of mass as fourth corner the second
// moments C = ∫ r rᵀ dV, then I = density (trace(C) E - C). For a tetrahedron (0, a, b, c) of
// signed volume V, C = V/20 (a aᵀ + b bᵀ + c cᵀ + s sᵀ) with s = a + b + c.
// Why: with the centre as origin the tensor comes out about the centre, with no parallel-axis step
// and its cancellation. Working far from the body's own place is what ruins other programs (chapter
// 2, "Far away").
// Source: Tonon 2004, in the vector form of Blow and Binstock 2004. Off-diagonal entries are minus
// the products of inertia: the signs that are most often wrong.
// Not handled: bad meshes beyond what requireUsable() sees.

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// The inertia tensor of the solid inside a closed mesh of constant density, about its centre of
/// mass, along the axes of the mesh. Negative for a mesh that is inside out.
/// \param mesh a closed surface [m]
/// \param density mass per volume [kg/m^3]
/// \return symmetric 3x3 tensor [kg m^2, axes of the mesh, about the centre of mass]
/// \throws InvalidInput if the mesh is unusable (requireUsable()), has no volume, or density is not
/// positive
/// \source{18}
/// \erratum{3.3,4.7}
/// \ingroup mass
Matrix3 inertiaTensor(const TriangleMesh& mesh, Real density);

}  // namespace carom
