#pragma once
// Newton's restitution and Coulomb's friction at once: the law that everybody writes down first.
//
// Asked for: the normal velocity after the impact is -e times that before; friction is at most mu
// times the normal impulse; if the contact slides after the impact, friction is at that limit and
// points against the slip that is then; otherwise the slip is zero.
// Method: eliminate the normal impulse (contact_equations.hpp). Left is S jt + w = -s jt, where w
// is the slip after an impact without friction and s >= 0 says how far from sticking we are: s = 0
// sticks, s = infinity has no friction. jt(s) = -(S + s)^-1 w moves from one to the other. If
// sticking lies in the cone, that is the answer. If not, |jt| - mu jn is positive at one end and
// not positive at the other, so there is a root for every S, and a bracket finds it.
// Why normal and friction together: solved one after the other, friction spoils the normal velocity
// that was just made right.
// Why this is not the law that Carom uses: it can make energy. When friction turns the body so that
// the contact is pressed harder, jn grows, and e of a larger impulse comes back (Kane and Levinson
// 1985; Stronge 1990). passive_impact.hpp cannot.
// Source: section 6.5, put right; the cone exactly, not a pyramid.
// Not handled: which answer is the right one where several exist (steep contacts with large mu):
// one of them is found, always the same for the same input.

#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/impact_law.hpp"

namespace carom {

/// The impulse of an impact after Newton and Coulomb.
/// \param a body A \param b body B \param contact where they touch
/// \param law restitution and friction; tangential restitution is not used
/// \return impulse on B, and whether the contact slides or sticks after it
/// \throws InvalidInput if a body, the contact or the law is not usable
/// \source{40,41,42,43,44}
/// \erratum{6.11,6.18}
/// \ingroup impulse
Impact coulombImpact(const MovingBody& a, const MovingBody& b, const Contact& contact,
                     const ImpactLaw& law);

/// The same in the plane, where there are only two directions to slide in and no search is needed.
/// \param a body A \param b body B \param contact where they touch
/// \param law restitution and friction; tangential restitution is not used
/// \return impulse on B, and whether the contact slides or sticks after it
/// \throws InvalidInput if a body, the contact or the law is not usable
/// \erratum{6.18}
/// \ingroup impulse
PlanarImpact coulombImpact(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
                           const ImpactLaw& law);

}  // namespace carom
