#pragma once
// Which way does a body face after turning for a while?
//
// The source writes "angle += angular velocity * dt" and means the quaternion product. Angular
// velocity given in the world turns after what is there already, so it multiplies from the left: q'
// = exp(omega dt / 2) q. That is exact while omega is constant, for any dt. The usual naive step, q
// += dt/2 omega q, leaves the unit sphere: after 10 s of case R8 the norm is 8.2. Angular
// velocities of one frame, unlike rotations, do add as vectors. What it does not handle: omega that
// changes during the step (integrate_body_rate.hpp).

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The orientation after turning at a constant angular velocity; exact but for rounding, norm
/// within 2 ulp of 1.
/// \param q orientation at the start, body to world; any norm but zero
/// \param angularVelocity omega [rad/s, world]
/// \param dt duration [s]; negative turns back
/// \return orientation at the end, body to world, unit norm
/// \throws InvalidInput if q is zero, or anything is not finite
/// \source{14}
/// \erratum{4.2,4.3}
/// \ingroup rotation
Quaternion integrateOrientation(const Quaternion& q, const Vector3& angularVelocity, Real dt);

}  // namespace carom
