#pragma once
// How long may the next step be?
//
// Method: try a step and look at the estimate of its error. If it is more than allowed, throw the
// step away. Either way the error goes like the fifth power of the step, so a step longer by the
// factor (allowed / error)^(1/5) would just do; take nine tenths of that, and change by no more
// than 5 times.
// Why: a comet needs thousands of short steps near the sun and a few long ones away from it. One
// length for all wastes most of them.
// Why not always: chosen steps undo what a symplectic method is for; energy drifts, if slowly. And
// the tolerance is per step: what the run as a whole is worth depends on the problem.
// Source: Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, 1993, II.4.
// Not handled: values between the steps, and higher orders (trajectory.hpp).

#include "carom/motion/adaptive.hpp"

namespace carom {

/// Follows a motion from one time to another with steps as long as the tolerance allows, by the
/// pair 5(4) of Dormand and Prince.
/// \param state positions and velocities at the start
/// \param time at the start [s]
/// \param end when to stop; earlier than `time` runs backwards [s]
/// \param tolerance what error is allowed per step
/// \param acceleration a(t, x, v)
/// \return the state at the end, or where and why it stopped before
/// \throws InvalidInput if a number is not finite, the absolute tolerance not positive, the
/// relative one negative, or maxSteps not positive
/// \ingroup motion
AdaptiveRun rkAdaptive(const State& state, Real time, Real end, const Tolerance& tolerance,
                       const Acceleration& acceleration);

}  // namespace carom
