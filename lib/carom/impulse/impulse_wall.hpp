#pragma once
// How hard does a body hit a wall?
//
// Method: the impulse of two bodies, with the wall as body A. Its inverse mass and inverse inertia
// are zero, so its terms are left out; its velocity is zero too.
// Why not a very large mass: the larger it is, the more digits the sum loses; zero is exact.
// Source: equation 33.
// Not handled: walls that move (impulse_3d.hpp, with an immovable A that has a velocity), friction.

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// The normal impulse between a body and a wall at rest, without friction.
/// \param body the body, B
/// \param arm from its centre of mass to the contact [m, world]
/// \param normal unit, out of the wall towards the body [1, world]
/// \param restitution e, from 0 (no bounce) to 1 (no loss) [1]
/// \return size of the impulse, j n on the body; 0 if its point does not approach, or it cannot be
/// moved [N s]
/// \throws InvalidInput if the body is not usable, the normal not of length one, the arm not
/// finite, or restitution not from 0 to 1
/// \source{33}
/// \ingroup impulse
Real impulseWall(const MovingBody& body, const Vector3& arm, const Vector3& normal,
                 Real restitution);

}  // namespace carom
