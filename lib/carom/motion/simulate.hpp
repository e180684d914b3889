#pragma once
// How is a motion followed for many steps?
//
// Method: count the steps with a whole number, and compute each time from the count. Adding dt to
// the time until it is ten seconds makes 101 steps of a tenth, because a tenth is no double: the
// source's loops take one step too many, and its table of tan x prints each value one line late.

#include "carom/motion/state.hpp"

namespace carom {

/// A method that makes one step, for example rk4. \ingroup motion
using Step =
    std::function<State(const State& state, Real time, Real dt, const Acceleration& acceleration)>;

/// Follows a motion for a number of equal steps. Step i begins at time + i dt.
/// \param step the method
/// \param state positions and velocities at the start
/// \param time at the start [s]
/// \param dt length of a step [s]
/// \param steps how many, zero or more
/// \param acceleration a(t, x, v)
/// \return positions and velocities at time + steps * dt
/// \throws InvalidInput if steps is negative or the method is missing, and what the method throws
/// \erratum{7.3,7.12}
/// \ingroup motion
State simulate(const Step& step, const State& state, Real time, Real dt, int steps,
               const Acceleration& acceleration);

}  // namespace carom
