#pragma once
// What does it change to use the new velocity at once?
//
// Method: v' = v + a dt, then x' = x + v' dt.
// Why: it costs what explicit Euler costs, and is of first order too, but it is symplectic: a
// spring keeps x^2 + v^2 - dt x v (unit mass and stiffness) forever, so its energy swings and does
// not grow, up to omega dt = 2. Most engines step like this.
// Source: the listing of section 7.1, whose text calls it forward Euler and warns against the other
// order of its lines for the opposite of the right reason; Hairer, Lubich and Wanner 2006, VI.3.
// Not handled: forces that depend on the velocity are taken at the old one, which is still of first
// order.

#include "carom/motion/state.hpp"

namespace carom {

/// One step of semi-implicit Euler, also called symplectic Euler. Order 1; energy does not drift.
/// \param state positions and velocities at the start of the step
/// \param time at the start of the step [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param acceleration a(t, x, v)
/// \return positions and velocities at time + dt
/// \throws InvalidInput if a number of the state, the time or the step is not finite, or the counts
/// of positions, velocities and accelerations differ
/// \source{46,47}
/// \erratum{7.2,7.9}
/// \ingroup motion
State semiImplicitEuler(const State& state, Real time, Real dt, const Acceleration& acceleration);

}  // namespace carom
