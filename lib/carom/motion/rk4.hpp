#pragma once
// Can four looks at the forces do better than one?
//
// Method: the classical step of Runge and Kutta. Look at the slope at the start (k1), twice in the
// middle (k2 with k1, k3 with k2), and at the end (k4 with k3); go on with their mean, weighted
// 1, 2, 2, 1. The slope of a position is the velocity, that of a velocity the acceleration.
// Why: order 4, so half the step leaves a sixteenth of the error; any force, any equation.
// Why not always: it is not symplectic. A pendulum at 60 steps a second loses a hundred-thousandth
// of its energy in half an hour, and goes on losing.
// Source: equations 50 to 56, which are right; the listing of section 7.4 takes k2 for k4's slope
// and is of third order, and prints every value one step late. Kutta 1901 has a whole family of
// such methods (the 3/8 rule is another); these equations fix the classical one.
// Not handled: choice of the step (rk_adaptive.hpp).

#include "carom/motion/state.hpp"

namespace carom {

/// One step of the classical method of Runge and Kutta. Order 4; energy drifts slowly.
/// \param state positions and velocities at the start of the step
/// \param time at the start of the step [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param acceleration a(t, x, v)
/// \return positions and velocities at time + dt
/// \throws InvalidInput if a number of the state, the time or the step is not finite, or the counts
/// of positions, velocities and accelerations differ
/// \source{50,51,52,53,54,55,56}
/// \erratum{7.10,7.11,7.13}
/// \ingroup motion
State rk4(const State& state, Real time, Real dt, const Acceleration& acceleration);

}  // namespace carom
