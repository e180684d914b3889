#pragma once
// What does the equation of motion need to know about a solid?
//
// Its mass, where its centre is, and how its mass is spread around that centre. This file holds the
// answer as a struct, and the function that weighs a mesh fast and to the last digits. The plain
// versions that the chapter explains are signed_volume, center_of_mass and inertia_tensor.
//
// Method: one pass over the triangles. Each triangle spans a tetrahedron with a local origin; the
// signed sums of the volumes and of their first and second moments are those of the solid
// (divergence theorem; Mirtich 1996, Eberly 2002, Tonon 2004). Three things make it accurate: the
// origin lies inside the bounding box, so a body far from the world's origin loses nothing; a
// determinant is formed from edges, so neighbouring corners do not cancel; partial sums of short
// blocks are added with compensation. Where the solid is thin (volume below kThinSolid of the
// bounding box) tetrahedra cancel against each other, and the pass is repeated in double-double
// arithmetic, which carries about 32 digits.
//
// Not handled: a density that varies; surfaces that cut themselves (parts inside twice count
// twice).

#include "carom/core/real.hpp"
#include "carom/mass/triangle_mesh.hpp"

namespace carom {

/// How a rigid body resists being pushed and turned.
/// \source{18}
/// \erratum{2.2}
/// \ingroup mass
struct MassProperties {
  Real volume = 0;                    ///< [m^3]
  Real mass = 0;                      ///< [kg]
  Vector3 center = Vector3::Zero();   ///< centre of mass [m, frame of the mesh]
  Matrix3 inertia = Matrix3::Zero();  ///< [kg m^2, axes of the mesh, about the centre of mass]
};

/// Ratio of volume to bounding box below which massProperties() computes in double-double. Errors
/// of the pass in double grow as the inverse of this ratio: at 1/1000 they are about 1e-14. Smaller
/// values trade digits for speed on thin bodies.
/// \ingroup mass
inline constexpr Real kThinSolid = 1e-3;

/// Volume, mass, centre and inertia of the solid inside a mesh of constant density. The mesh is
/// judged first.
/// \param mesh a closed surface that looks outwards [m]
/// \param density mass per volume, positive [kg/m^3]
/// \return centre in the frame of the mesh, inertia about it along the axes of the mesh
/// \throws InvalidInput with the first problem that checkMesh() finds, or if density is not
/// positive
/// \erratum{3.3} \ingroup mass
MassProperties massProperties(const TriangleMesh& mesh, Real density);

/// As massProperties(), for a mesh that checkMesh() has found good already: judging costs several
/// times as much as weighing, even when it is quick. A mesh that is still bad gives wrong numbers,
/// but no access outside its arrays.
/// \param mesh a mesh for which checkMesh() is empty [m]
/// \param density mass per volume, positive [kg/m^3]
/// \return as massProperties()
/// \throws InvalidInput if an index names no vertex, a sum is not finite, or the volume or density
/// is not positive
/// \ingroup mass
MassProperties massPropertiesOfGoodMesh(const TriangleMesh& mesh, Real density);

}  // namespace carom
