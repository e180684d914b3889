#pragma once
// How hard do two planar bodies hit each other?
//
// Method: find the impulse along the normal after which the points part at e times the speed at
// which they met: j = -(1 + e) u.n / (1/mA + 1/mB + (rA x n)^2/IA + (rB x n)^2/IB).
// Why the cross product: an impulse that points at the centre of mass turns nothing, and there
// r x n is zero. The source writes r . n, which is largest exactly there: a smooth disc that meets
// a wall head-on would go on into the wall.
// Source: equations 28 to 31, put right.
// Not handled: friction (coulomb_impact.hpp), several contacts at once (simultaneous_impacts.hpp).

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// The normal impulse between two planar bodies without friction.
/// \param a body A
/// \param b body B
/// \param contact normal from A to B, and the arms
/// \param restitution e, from 0 (no bounce) to 1 (no loss) [1]
/// \return size of the impulse, j n on B and -j n on A; 0 if the points do not approach, or neither
/// body can be moved [N s]
/// \throws InvalidInput if a body or the contact is not usable, or restitution not from 0 to 1
/// \source{27,28,29,30,31}
/// \erratum{6.2,6.5}
/// \ingroup impulse
Real impulse2d(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
               Real restitution);

}  // namespace carom
