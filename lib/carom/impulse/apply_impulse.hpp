#pragma once
// What does an impulse do to the two bodies it acts between?
//
// Method: B's velocity changes by J/m, its angular velocity by I^-1 (r x J); A's by the opposite.
// The torque is known along the world's axes and the tensor along the body's: the torque is turned
// into the body, divided by the inertia there, and the result turned back.
// The arm of a compound starts at the common centre of mass, whichever of its parts is hit.
// Why both at once: whatever B gets, A loses. Then momentum and angular momentum are kept to the
// last digit, whatever J was, right or wrong.
// Source: equations 28 to 30 and 41 to 44, put right.
// Not handled: how large J is (impulse_3d.hpp, friction_impulse.hpp).

#include "carom/core/real.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

/// Changes the velocities of two bodies by an impulse between them.
/// \param a gets -impulse; its velocity is changed
/// \param armA from A's centre of mass to where the impulse acts [m, world]
/// \param b gets +impulse; its velocity is changed
/// \param armB from B's centre of mass to where the impulse acts [m, world]
/// \param impulse any direction [N s, world]
/// \throws InvalidInput if an arm or the impulse is not finite; the bodies are then unchanged
/// \source{17,28,29,30,41,42,43,44}
/// \erratum{4.1,4.4,4.6,6.2,6.3,6.4,6.7,6.17}
/// \ingroup impulse
void applyImpulse(OrientedBody& a, const Vector3& armA, OrientedBody& b, const Vector3& armB,
                  const Vector3& impulse);

}  // namespace carom
