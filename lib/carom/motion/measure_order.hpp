#pragma once
// Of which order is a method, as measured?
//
// Method: run it with two steps, of which the second is the smaller. If the error goes like dt^p,
// then p = log(error1/error2) / log(dt1/dt2).
// Why measure: one wrong index in a formula costs orders and shows in no picture. The source's RK4
// looks right and is of order three.
// Not handled: steps so large that the next power still counts, and so small that rounding does;
// between them the number settles, so ask for several pairs and look.

#include "carom/core/real.hpp"

namespace carom {

/// An error, and the step that made it. \ingroup motion
struct StepError {
  Real dt = 0;     ///< length of the step, positive [s]
  Real error = 0;  ///< absolute error at the end, positive [any unit]
};

/// The order of a method from two runs of it.
/// \param coarse the run with the larger step
/// \param fine the run with the smaller step
/// \return p, by which the error goes like dt^p [1]
/// \throws InvalidInput if a step or an error is not positive and finite, or the first step not the
/// larger
/// \ingroup motion
Real measureOrder(const StepError& coarse, const StepError& fine);

}  // namespace carom
