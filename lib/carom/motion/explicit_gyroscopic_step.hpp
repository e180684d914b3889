#pragma once
// What happens if equation 16 is simply stepped forward?
//
// Method: w' = w - dt I^-1 (w x I w).
// Why it stands here: to be seen failing. The step is at right angles to w in the sense of the
// energy, so every step makes the energy larger: at 60 steps a second a body that tumbles at 2
// rad/s has gained 17 % after ten seconds, and it goes on. See gyroscopic_step.hpp,
// split_rotor.hpp, free_rotor.hpp.
// Source: equations 15 and 16 as an algorithm.

#include "carom/core/real.hpp"

namespace carom {

/// The angular velocity after the gyroscopic term has acted for a step: explicit Euler. Order 1;
/// gains energy without bound.
/// \param moments principal moments of inertia [kg m^2]
/// \param angularVelocity [rad/s, body]
/// \param dt length of the step [s]
/// \return angular velocity after it, as if only this term acted [rad/s, body]
/// \throws InvalidInput if a number is not finite or a moment not positive
/// \source{15,16}
/// \erratum{4.5}
/// \ingroup motion
Vector3 explicitGyroscopicStep(const Vector3& moments, const Vector3& angularVelocity, Real dt);

}  // namespace carom
