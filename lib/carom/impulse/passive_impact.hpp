#pragma once
// Friction and restitution in an impact that never makes energy, whatever the bodies.
//
// Method: Chatterjee and Ruina's law. Two impulses frame all that can happen to a plastic contact:
// P_I has no friction and stops the normal velocity, P_II = -K^-1 u stops all. The answer is
//   P = (1 + e) P_I + (1 + e_t) (P_II - P_I)   if that lies in the cone of friction,
//   P = (1 + e) P_I + k (P_II - P_I)           with k such that it lies on the cone, else.
// k comes from one division, because both parts are known and only one is scaled.
// Why energy never grows: n . K (P_II - P_I) = 0, since both stop the normal velocity. So the two
// parts are perpendicular in the product x . K y, the second leaves the normal velocity alone,
// which becomes exactly -e u.n, and the energy changes by
//   -(a - a^2/2) P_I . K P_I - (b - b^2/2) (P_II - P_I) . K (P_II - P_I)
// with a = 1 + e and b = 1 + e_t or k. Neither bracket is negative for a and b from 0 to 2, and k
// lies between 0 and 1 + e_t.
// Why not Newton with Coulomb (coulomb_impact.hpp): it can make energy. The price: a contact that
// slides has its friction along P_II - P_I, which need not be exactly against the slip at the end.
// For balls and other bodies whose K does not couple the directions both laws are the same.
// Source: Chatterjee and Ruina, Journal of Applied Mechanics 65 (1998) 939. The super ball is e_t =
// 1 (Garwin 1969).
// Not handled: several contacts at once (simultaneous_impacts.hpp).

#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/impact_law.hpp"

namespace carom {

/// The impulse of an impact with friction that makes no energy.
/// \param a body A \param b body B \param contact where they touch
/// \param law restitution, friction, and tangential restitution
/// \return impulse on B, and whether friction was at its limit
/// \throws InvalidInput if a body, the contact or the law is not usable
/// \erratum{6.11,6.18,6.20}
/// \ingroup impulse
Impact passiveImpact(const MovingBody& a, const MovingBody& b, const Contact& contact,
                     const ImpactLaw& law);

/// The same in the plane.
/// \param a body A \param b body B \param contact where they touch
/// \param law restitution, friction, and tangential restitution
/// \return impulse on B, and whether friction was at its limit
/// \throws InvalidInput if a body, the contact or the law is not usable
/// \ingroup impulse
PlanarImpact passiveImpact(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
                           const ImpactLaw& law);

}  // namespace carom
