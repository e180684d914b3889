#pragma once
// How does a step keep a tumbling body from spinning up out of nothing?
//
// Method: Euler's equation with the angular velocity at the end of the step, w' :
//   I (w' - w) + dt w' x I w' = 0.
// Newton's method from w' = w, one turn: the derivative of the left side is
//   J = I + dt ([w]x I - [I w]x), and w' = w - J^-1 (dt w x I w).
// Why: the explicit step gains energy without bound, this one loses some: at 60 steps a second a
// body that tumbles at 2 rad/s has lost 13 % after ten seconds. A game prefers that to an
// explosion.
// Source: Catto, Numerical Methods, Game Developers Conference 2015; equation 16 for the term.
// Not handled: a body that turns by more than about a radian in a step, for which one turn of
// Newton's method is no solution and the energy can leap; and accuracy, for which split_rotor.hpp
// costs hardly more and keeps the energy.

#include "carom/core/real.hpp"

namespace carom {

/// The angular velocity after the gyroscopic term has acted for a step: implicit Euler, one turn of
/// Newton's method. Order 1; loses energy.
/// \param inertia tensor about the centre of mass, symmetric and positive definite [kg m^2, body]
/// \param angularVelocity [rad/s, body]
/// \param dt length of the step [s]
/// \return angular velocity after it, as if only this term acted [rad/s, body]
/// \throws InvalidInput if a number is not finite, or the matrix of Newton's method is singular
/// \ingroup motion
Vector3 gyroscopicStep(const Matrix3& inertia, const Vector3& angularVelocity, Real dt);

}  // namespace carom
