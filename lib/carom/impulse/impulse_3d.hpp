#pragma once
// How hard do two bodies of any shape hit each other?
//
// Method: as in the plane, with the full tensors: j = -(1 + e) u.n / (n . K n), where n . K n is
// 1/mA + 1/mB + n . (IA^-1 (rA x n) x rA) + n . (IB^-1 (rB x n) x rB).
// Why the tensors must be along the world's axes: n and r are, and a rod along x is easily turned
// about x only as long as it still lies there.
// Source: equation 32, which is right.
// Not handled: friction (coulomb_impact.hpp), several contacts at once (simultaneous_impacts.hpp).

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// The normal impulse between two bodies without friction.
/// \param a body A
/// \param b body B
/// \param contact normal from A to B, and the arms
/// \param restitution e, from 0 (no bounce) to 1 (no loss) [1]
/// \return size of the impulse, j n on B and -j n on A; 0 if the points do not approach, or neither
/// body can be moved [N s]
/// \throws InvalidInput if a body or the contact is not usable, or restitution not from 0 to 1
/// \source{32,37,38,39}
/// \erratum{1.2,6.9}
/// \ingroup impulse
Real impulse3d(const MovingBody& a, const MovingBody& b, const Contact& contact, Real restitution);

}  // namespace carom
