#pragma once
// Mass properties in closed form: what the integrals over meshes must agree with.
//
// Method: textbook integrals. Every solid has its symmetry axis along z, and its frame is stated.
// Why: exact, and the engine's own shapes are weighed by them.
// Source: equation 18 for the box; Spiegel, Lipschutz and Liu, Mathematical Handbook; the capsule
// is a cylinder and two half balls moved by parallel axes.
// Not handled: solids whose density varies.

#include "carom/core/real.hpp"
#include "carom/mass/mass_properties.hpp"

namespace carom {

/// A ball about the origin.
/// \param radius positive [m]
/// \param density positive [kg/m^3]
/// \return centre at the origin
/// \throws InvalidInput if an argument is not positive and finite
/// \ingroup mass
MassProperties solidBall(Real radius, Real density);

/// A ball with a concentric hollow.
/// \param innerRadius radius of the hollow, at least zero [m]
/// \param outerRadius larger than innerRadius [m]
/// \param density positive [kg/m^3]
/// \return centre at the origin
/// \throws InvalidInput if the radii are not 0 <= inner < outer, or density is not positive and
/// finite
/// \ingroup mass
MassProperties hollowBall(Real innerRadius, Real outerRadius, Real density);

/// A box about the origin.
/// \param size full edge lengths along x, y, z, positive [m]
/// \param density positive [kg/m^3]
/// \return centre at the origin
/// \throws InvalidInput if an argument is not positive and finite
/// \source{18}
/// \ingroup mass
MassProperties solidBox(const Vector3& size, Real density);

/// An ellipsoid about the origin.
/// \param semiAxes half lengths along x, y, z, positive [m]
/// \param density positive [kg/m^3]
/// \return centre at the origin
/// \throws InvalidInput if an argument is not positive and finite
/// \ingroup mass
MassProperties solidEllipsoid(const Vector3& semiAxes, Real density);

/// A cylinder along z about the origin.
/// \param radius positive [m]
/// \param height full length along z, positive [m]
/// \param density positive [kg/m^3]
/// \return centre at the origin
/// \throws InvalidInput if an argument is not positive and finite
/// \ingroup mass
MassProperties solidCylinder(Real radius, Real height, Real density);

/// A capsule along z about the origin: a cylinder with a half ball at each end.
/// \param radius of cylinder and balls, positive [m]
/// \param height of the cylinder alone, at least zero [m]
/// \param density positive [kg/m^3]
/// \return centre at the origin
/// \throws InvalidInput if radius or density is not positive and finite, or height is negative
/// \ingroup mass
MassProperties solidCapsule(Real radius, Real height, Real density);

/// A cone with its base in the plane z = 0 and its tip at z = height.
/// \param radius of the base, positive [m]
/// \param height positive [m]
/// \param density positive [kg/m^3]
/// \return centre at (0, 0, height/4)
/// \throws InvalidInput if an argument is not positive and finite
/// \ingroup mass
MassProperties solidCone(Real radius, Real height, Real density);

/// A tetrahedron with four given corners, in any order.
/// \param a first corner [m]
/// \param b second corner [m]
/// \param c third corner [m]
/// \param d fourth corner [m]
/// \param density positive [kg/m^3]
/// \return centre at the mean of the corners, inertia along the axes in which the corners are given
/// \throws InvalidInput if the corners lie in one plane or are not finite, or density is not
/// positive
/// \ingroup mass
MassProperties solidTetrahedron(const Vector3& a, const Vector3& b, const Vector3& c,
                                const Vector3& d, Real density);

/// A torus about the origin, round the z axis.
/// \param ringRadius from the axis to the middle of the tube, at least tubeRadius [m]
/// \param tubeRadius positive [m]
/// \param density positive [kg/m^3]
/// \return centre at the origin
/// \throws InvalidInput if 0 < tubeRadius <= ringRadius does not hold or density is not positive
/// \ingroup mass
MassProperties solidTorus(Real ringRadius, Real tubeRadius, Real density);

}  // namespace carom
