#pragma once
// Can a rotation be stepped like any other equation?
//
// Method: the classical Runge-Kutta step on seven numbers, q' = q w / 2 and Euler's equation. The
// four of the quaternion leave the unit sphere a little, so they are put back at the end.
// Why: order 4, any torque, nothing to think about.
// Why not: it keeps neither the energy nor the angular momentum, and shrinking the quaternion back
// hides the error without removing it. split_rotor.hpp keeps both for the same cost.

#include <functional>

#include "carom/motion/rotor.hpp"

namespace carom {

/// Answers tau(t, state): the torque about the centre of mass [N m, body] at a time [s]. Empty:
/// none.
/// \ingroup motion
using Torque = std::function<Vector3(Real time, const RotorState& state)>;

/// One step of the classical method of Runge and Kutta for a body that turns. Order 4.
/// \param moments principal moments of inertia [kg m^2]
/// \param state attitude and angular velocity at the start
/// \param time at the start [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param torque what acts on the body; empty for nothing. It may be asked with a quaternion that
/// is not quite of norm one
/// \return attitude and angular velocity at time + dt
/// \throws InvalidInput if a number is not finite, a moment not positive, or the quaternion not of
/// norm one
/// \ingroup motion
RotorState rk4Rotor(const Vector3& moments, const RotorState& state, Real time, Real dt,
                    const Torque& torque = {});

}  // namespace carom
