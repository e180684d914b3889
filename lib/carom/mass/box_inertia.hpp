#pragma once
// The inertia of a box, the one tensor that everybody knows by heart.
//
// Method: the integral of (y² + z²) over the box is m/12 (height² + depth²), and so on round. Full
// lengths: with half lengths the factor is 1/3, and mixing them up is wrong by a factor of four.
// Why: closed form; also the reference for the mesh integrals.
// Source: equation 18.
// Not handled: boxes whose axes are turned (rotateInertia() turns the result).

#include "carom/core/real.hpp"

namespace carom {

/// The inertia tensor of a solid box about its centre, along its own axes.
/// \param mass positive [kg]
/// \param size full edge lengths along x, y, z, all positive [m]
/// \return diagonal 3x3 tensor [kg m^2, axes of the box, about its centre]
/// \throws InvalidInput if mass or an edge is not positive and finite
/// \source{18}
/// \ingroup mass
Matrix3 boxInertia(Real mass, const Vector3& size);

}  // namespace carom
