#pragma once
// How fast does the rotation of a body change?
//
// Method: Euler's equation I w' = tau - w x I w, solved for w'. Without torque the angular momentum
// L = I w keeps its direction in space. Along the body's own axes, which turn with w, the same L
// turns backwards, with -w x L; the tensor stays what it is.
// Why the last term: without it a tumbling box would keep its angular velocity, and its angular
// momentum would turn along with it. Its attitude is then wrong by 0.8 rad after ten seconds.
// Source: equation 16.
// Not handled: steps in time; the explicit step with this formula gains energy (chapter 6).

#include "carom/core/real.hpp"

namespace carom {

/// The angular acceleration of a rigid body. All arguments are given along the same axes; along the
/// body's own the inertia is constant.
/// \param inertia tensor about the centre of mass [kg m^2, body]
/// \param angularVelocity [rad/s, body]
/// \param torque about the centre of mass [N m, body]
/// \return angular acceleration [rad/s^2, body]
/// \throws InvalidInput if a number is not finite, or the inertia not symmetric and positive
/// definite
/// \source{16}
/// \erratum{3.1,4.4}
/// \ingroup impulse
Vector3 angularAcceleration(const Matrix3& inertia, const Vector3& angularVelocity,
                            const Vector3& torque);

}  // namespace carom
