#pragma once
// The composed methods of composition.hpp behind the plain interface of this chapter.

#include "carom/motion/state.hpp"

namespace carom {

/// One step of Yoshida's method of order 4: three forces, energy does not drift.
/// \param state positions and velocities at the start of the step
/// \param time at the start of the step [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param acceleration a(t, x, v), not dependent on v: it is given the velocity of the last kick
/// \return positions and velocities at time + dt
/// \throws InvalidInput if a number of the state, the time or the step is not finite, or the counts
/// of positions, velocities and accelerations differ
/// \ingroup motion
State yoshida4(const State& state, Real time, Real dt, const Acceleration& acceleration);

/// One step of Yoshida's method of order 6: seven forces, energy does not drift.
/// \param state positions and velocities at the start of the step
/// \param time at the start of the step [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param acceleration a(t, x, v), not dependent on v: it is given the velocity of the last kick
/// \return positions and velocities at time + dt
/// \throws InvalidInput if a number of the state, the time or the step is not finite, or the counts
/// of positions, velocities and accelerations differ
/// \ingroup motion
State yoshida6(const State& state, Real time, Real dt, const Acceleration& acceleration);

}  // namespace carom
