#pragma once
// Which of the two laws of impact does a world use?
//
// Method: Newton's restitution with Coulomb's friction (coulomb_impact.hpp) where that makes no
// energy, which is a sum away; the passive law (passive_impact.hpp) where it would.
// Why: a contact that sticks should stop its slip. The passive law leaves some of it if the contact
// bounces and the body couples both directions, a corner that hits off its middle. Newton's and
// Coulomb's laws do not, and only for some steep corners do they make energy.
// Source: section 6.5; the test of energy: Stronge 1990.
// Not handled: what happens between both laws: the answer jumps where the energy begins to grow.

#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/impact_law.hpp"

namespace carom {

/// The impulse of an impact with friction that stops the slip of a contact that sticks, and makes
/// no energy. \param a body A \param b body B \param contact where they touch
/// \param law restitution and friction; tangential restitution is not used
/// \return impulse on B, and whether the contact slides or sticks after it
/// \throws InvalidInput if a body, the contact or the law is not usable
/// \ingroup impulse
Impact boundedImpact(const MovingBody& a, const MovingBody& b, const Contact& contact,
                     const ImpactLaw& law);

}  // namespace carom
