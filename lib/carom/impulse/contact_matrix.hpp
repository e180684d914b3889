#pragma once
// How does a contact answer to an impulse in any direction?
//
// Method: the relative velocity of the two points changes by K J, with
// K = (1/mA + 1/mB) E - [rA] IA^-1 [rA] - [rB] IB^-1 [rB], where [r] is the matrix of r x.
// K is symmetric, and positive definite as soon as one of the bodies is free. Its diagonal holds
// the inverse effective masses; what stands beside it is why friction changes the normal velocity.
// Source: Mirtich, thesis 1996, chapter 3; the denominator of equation 32 is n . K n.
// Not handled: several contacts of the same bodies, which answer together
// (simultaneous_impacts.hpp).

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// The matrix that turns an impulse on B at a contact into the change of the relative velocity.
/// \param a how easily A is moved \param b how easily B is moved
/// \param contact the arms; the normal is not used
/// \return K, exactly symmetric [1/kg, world]
/// \source{32}
/// \ingroup impulse
Matrix3 contactMatrix(const BodyMass& a, const BodyMass& b, const Contact& contact);

/// The same in the plane.
/// \param a how easily A is moved \param b how easily B is moved
/// \param contact the arms; the normal is not used
/// \return K, exactly symmetric [1/kg, world]
/// \ingroup impulse
Matrix2 contactMatrix(const PlanarBodyMass& a, const PlanarBodyMass& b,
                      const PlanarContact& contact);

/// What an impulse does to the kinetic energy of both bodies together: u . J + J . K J / 2.
/// \param K matrix of the contact (contactMatrix()) [1/kg]
/// \param u relative velocity before the impulse [m/s]
/// \param impulse J on B [N s, same axes]
/// \return energy after minus energy before; negative: energy is lost [J]
/// \ingroup impulse
Real impactEnergyChange(const Matrix3& K, const Vector3& u, const Vector3& impulse);

/// The same in the plane. \param K matrix of the contact [1/kg]
/// \param u relative velocity before the impulse [m/s] \param impulse on B [N s, same axes]
/// \return energy after minus energy before [J]
/// \ingroup impulse
Real impactEnergyChange(const Matrix2& K, const Vector2& u, const Vector2& impulse);

}  // namespace carom
