#pragma once
// Where is everything a moment later, if for that moment nothing changed?
//
// Method: x' = x + v dt, v' = v + a dt, both with the velocity and the acceleration of the start.
// Why: it is the simplest step there is, and of first order: half the step, half the error.
// Why not: what moves on a circle is led along the tangent, a little outwards each time. A spring
// gains the factor 1 + (omega dt)^2 of energy with every step, until everything flies apart.
// Source: section 4.1, equations 11 and 13; section 7.1, which calls by this name the method of
// semi_implicit_euler.hpp; Hairer, Lubich and Wanner, Geometric Numerical Integration, 2006, I.1.2.
// Gravity is one of the forces in a: equation 45 adds it a second time.

#include "carom/motion/state.hpp"

namespace carom {

/// One step of explicit Euler, also called forward Euler. Order 1; gains energy.
/// \param state positions and velocities at the start of the step
/// \param time at the start of the step [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param acceleration a(t, x, v)
/// \return positions and velocities at time + dt
/// \throws InvalidInput if a number of the state, the time or the step is not finite, or the counts
/// of positions, velocities and accelerations differ
/// \source{11,13,45}
/// \erratum{7.1}
/// \ingroup motion
State explicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration);

}  // namespace carom
