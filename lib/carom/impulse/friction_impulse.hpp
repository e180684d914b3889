#pragma once
// How much does friction take from the slip at a contact?
//
// Method: Coulomb's two cases. The impulse that would stop the slip is m_t times its speed, against
// its direction. If that is no more than mu times the normal impulse, the bodies stick, and this is
// the friction. If it is more, they go on sliding, and friction is mu times the normal impulse.
// Why a direction of length one: the slip only says where to; how much is the business of the
// normal impulse. The source multiplies the slip with itself instead, so that its friction grows
// with the seventh power of the speed, and its factor 1 + c belongs to restitution.
// Source: section 6.4 and equations 35, 36 and 40, put right; Coulomb 1785.
// Not handled: friction that changes the normal impulse (coulomb_impact.hpp), spinning
// (spinning_friction.hpp).

#include "carom/core/real.hpp"

namespace carom {

/// The friction impulse at one contact.
/// \param relativeVelocity of B's point against A's; the part along the normal is ignored
/// [m/s, world]
/// \param normal unit, from A to B [1, world]
/// \param normalImpulse size of the impulse along the normal, zero or positive [N s]
/// \param friction mu, zero or positive; more than 1 for rubber [1]
/// \param tangentialMass effective mass along the slip, positive (effectiveMass()) [kg]
/// \return impulse on B, perpendicular to the normal; A gets the opposite [N s, world]
/// \throws InvalidInput if a number is not finite or out of the range named here
/// \source{35,36,40}
/// \erratum{6.11,6.12,6.13,6.14,6.15,6.16}
/// \ingroup impulse
Vector3 frictionImpulse(const Vector3& relativeVelocity, const Vector3& normal, Real normalImpulse,
                        Real friction, Real tangentialMass);

}  // namespace carom
