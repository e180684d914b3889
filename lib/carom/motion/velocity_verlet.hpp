#pragma once
// How does Verlet's method look with a velocity in it?
//
// Method: x' = x + v dt + a dt^2/2; then the force at the new place gives a', and
// v' = v + (a + a') dt/2. The mean of both accelerations is what makes it of second order.
// Why: position and velocity at the same moment, no drift of the energy, and the same positions as
// verlet.hpp. For a force that depends on the velocity, a' needs v', which is not known yet; the
// old v in its place would lower the order to one. The guess v + a dt is good enough for order two.
// Source: equations 48 and 49; Swope, Andersen, Berens and Wilson, Journal of Chemical Physics 76,
// 1982. The listing of section 7.3 uses x where it means s, and never asks for the force again.
// Not handled: with such a guess a step is no longer the exact reverse of the step back. The force
// is asked for twice a step; composition.hpp keeps it from one step to the next.

#include "carom/motion/state.hpp"

namespace carom {

/// One step of velocity Verlet. Order 2, also for forces that depend on the velocity; energy does
/// not drift where they do not.
/// \param state positions and velocities at the start of the step
/// \param time at the start of the step [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param acceleration a(t, x, v)
/// \return positions and velocities at time + dt
/// \throws InvalidInput if a number of the state, the time or the step is not finite, or the counts
/// of positions, velocities and accelerations differ
/// \source{48,49}
/// \erratum{7.7,7.8}
/// \ingroup motion
State velocityVerlet(const State& state, Real time, Real dt, const Acceleration& acceleration);

}  // namespace carom
