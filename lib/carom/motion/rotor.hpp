#pragma once
// What does a simulation know about a body that turns?
//
// Its attitude and its angular velocity. Both are written so that formulas are short: the attitude
// as a quaternion from body to world, the angular velocity along the axes of the body, where the
// inertia tensor does not change. The body's axes are its principal axes (principal_axes.hpp finds
// them), so that the tensor is three numbers.
// Without torque the angular momentum L stays what it is in the world. Seen from the body, which
// turns, it turns backwards: that is why w changes even when nothing acts, and why the frame of the
// body is no inertial frame.

#include "carom/core/real.hpp"
#include "carom/rotation/quaternion.hpp"

namespace carom {

/// How a body lies and turns. \ingroup motion
struct RotorState {
  Quaternion q_WB;                            ///< attitude, body to world, unit norm
  Vector3 angularVelocity = Vector3::Zero();  ///< [rad/s, body]
};

/// The angular momentum of a body, as the world sees it. Without torque it stays what it is.
/// \param moments principal moments of inertia [kg m^2]
/// \param state attitude and angular velocity
/// \return L [kg m^2/s, world]
/// \ingroup motion
Vector3 angularMomentum(const Vector3& moments, const RotorState& state);

/// The energy in the rotation of a body. Without torque it stays what it is.
/// \param moments principal moments of inertia [kg m^2]
/// \param angularVelocity [rad/s, body]
/// \return kinetic energy [J]
/// \ingroup motion
Real rotationEnergy(const Vector3& moments, const Vector3& angularVelocity);

/// The angular acceleration of a body with these principal moments: Euler's equation.
/// \param moments principal moments of inertia [kg m^2]
/// \param angularVelocity [rad/s, body]
/// \param torque about the centre of mass [N m, body]
/// \return [rad/s^2, body]
/// \source{16}
/// \erratum{3.1}
/// \ingroup motion
Vector3 eulerAcceleration(const Vector3& moments, const Vector3& angularVelocity,
                          const Vector3& torque);

/// Refuses moments that no body has. \param moments principal moments of inertia [kg m^2]
/// \throws InvalidInput if one is not positive and finite
/// \ingroup motion
void requireMoments(const Vector3& moments);

/// Refuses a state that cannot be worked with. \param state any state
/// \throws InvalidInput if a number is not finite, or the quaternion not of norm one within 1e-6
/// \ingroup motion
void requireUsable(const RotorState& state);

}  // namespace carom
