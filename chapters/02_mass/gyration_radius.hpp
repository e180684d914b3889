#pragma once
// At which distance from an axis would a body's mass, all in one point, be as hard to turn?
//
// Method: the moment about a unit axis n through the centre of mass is n · I n, and a point of mass
// m at the distance k has m k². Why: k is a length, so bodies of different mass can be compared at
// a glance. Source: section 4.2.1 of the source text, corrected: it takes the inverse of the
// tensor. Not handled: axes that miss the centre of mass (k² then grows by the squared distance).

#include "carom/core/real.hpp"
#include "carom/mass/mass_properties.hpp"

namespace carom {

/// The radius of gyration of a body about an axis through its centre of mass.
/// \param body mass and inertia about the centre of mass, both positive
/// \param axis direction of the axis, any length but zero [axes of the inertia]
/// \return radius k, where m k² is the moment about the axis [m]
/// \throws InvalidInput if the mass is not positive, or the axis is zero or not finite
/// \ingroup mass
Real gyrationRadius(const MassProperties& body, const Vector3& axis);

}  // namespace carom
