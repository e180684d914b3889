#pragma once
// With how much mass do two bodies resist each other at their contact?
//
// Method: push the two apart at the contact with a unit impulse along n and see how fast the points
// part: k = 1/mA + 1/mB + n . (IA^-1 (rA x n) x rA) + n . (IB^-1 (rB x n) x rB). One over that is
// the mass.
// Why inverse masses: a wall has none, and its terms vanish. Bodies that are hit off-centre give
// way by turning, so they are lighter there than on a scale.
// Source: the denominator of equation 32.
// Not handled: friction; along another direction the mass is another (contact_matrix.hpp).

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// The mass that a contact feels along its normal: an impulse J along it changes the speed at which
/// the two points part by J over this mass.
/// \param a how easily A is moved [world]
/// \param b how easily B is moved [world]
/// \param contact normal and arms
/// \return effective mass, positive [kg]; infinite if neither body can be moved
/// \throws InvalidInput if the contact is not usable (requireUsable())
/// \source{32}
/// \ingroup impulse
Real effectiveMass(const BodyMass& a, const BodyMass& b, const Contact& contact);

}  // namespace carom
