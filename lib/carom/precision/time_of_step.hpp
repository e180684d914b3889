#pragma once
// What time is it after n steps?
//
// A clock that adds up its steps, t += dt, collects the rounding error of every addition, and that
// of dt itself n times: after an hour of sixtieths a float is 12 ms late and has made 169 steps too
// many. A whole number counts without error, and count times step is rounded once.

#include <cstdint>

#include "carom/core/real.hpp"

namespace carom {

/// The time after a number of steps: start + step dt. Right to half an ulp of the product and half
/// an ulp of the sum, however many steps there are.
/// \erratum{7.3}
/// \param step how many steps have been made, at most 2^53 either way
/// \param dt length of a step [s]
/// \param start time before the first step [s]
/// \return the time [s]
/// \throws InvalidInput if dt or start is not finite, or step is beyond 2^53
/// \ingroup precision
Real timeOfStep(std::int64_t step, Real dt, Real start);

}  // namespace carom
