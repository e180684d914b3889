#pragma once
// Which impulse stops the slip of a contact and parts it with e, both at once?
//
// Method: an impulse J changes the velocity of the contact by K J (contactMatrix()). Wanted are a
// slip of zero and a normal velocity of -e times that before: two equations for the two parts of J.
// Why not one after the other: what stands beside the diagonal of K. Friction turns the body, and
// turning moves the contact along the normal; whatever comes second spoils what came first.
// Source: section 6.5 of the source text, put right.
// Not handled: the cone. If friction would have to be larger than it allows the contact slides
// (coulomb_impact.hpp).

#include "carom/core/real.hpp"

namespace carom {

/// The impulse of an impact that sticks, in the plane. x is along the floor, y out of it.
/// \param K matrix of the contact, symmetric and positive definite [1/kg]
/// \param velocity of the contact before: slip and normal velocity, u [m/s]
/// \param restitution e, from 0 (no bounce) to 1 (no loss) [1]
/// \return friction and normal impulse, after which the contact does not slip and parts at -e u.y
/// [N s]
/// \throws InvalidInput if a number is not finite, K not symmetric and positive definite, or
/// restitution not from 0 to 1
/// \erratum{6.18}
/// \ingroup impulse
Vector2 stickingImpulse(const Matrix2& K, const Vector2& velocity, Real restitution);

}  // namespace carom
