#pragma once
// How large is the error of a step whose answer nobody knows?
//
// Method: the seven slopes of Dormand and Prince give two results, one of order 5 and one of order
// 4. Their difference is about the error of the poorer one; the better one is kept.
// Why: the estimate costs nothing but additions. The last slope is the first one of the next step,
// so a step costs six looks at the forces.
// Source: Dormand and Prince, Journal of Computational and Applied Mathematics 6, 1980.
// Not handled: errors that both results share, as where a force jumps and no slope sees it.

#include "carom/motion/state.hpp"

namespace carom {

/// A step, and how wrong it may be. \ingroup motion
struct EmbeddedStep {
  State end;    ///< positions and velocities at the end, of order 5
  State error;  ///< difference to the result of order 4
};

/// One step of the pair 5(4) of Dormand and Prince.
/// \param state positions and velocities at the start of the step
/// \param time at the start of the step [s]
/// \param dt length of the step; negative runs backwards [s]
/// \param acceleration a(t, x, v)
/// \return positions and velocities at time + dt, and an estimate of their error
/// \throws InvalidInput if a number of the state, the time or the step is not finite, or the counts
/// of positions, velocities and accelerations differ
/// \ingroup motion
EmbeddedStep embeddedStep(const State& state, Real time, Real dt, const Acceleration& acceleration);

/// The error of a step in units of what is allowed: the root of the mean square of
/// error / (absolute + relative * larger of the sizes before and after).
/// \param before positions and velocities at the start
/// \param step the step and its error
/// \param absolute error allowed near zero, positive [m and m/s]
/// \param relative error allowed, as a share of the size, zero or positive [1]
/// \return at most 1 for a step that will do; infinite if the step has left the doubles
/// \throws InvalidInput if absolute is not positive and finite, or relative negative
/// \ingroup motion
Real errorRatio(const State& before, const EmbeddedStep& step, Real absolute, Real relative);

}  // namespace carom
