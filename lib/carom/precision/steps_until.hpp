#pragma once
// How many steps is a duration long?
//
// while (t < end) asks a rounded number whether the end has come, and goes once too often when t
// stops a little short: 101 steps of a tenth make ten. The number of steps is known before the
// first one: the duration divided by the step, rounded to a whole number.

#include <cmath>
#include <cstdint>

#include "carom/core/checks.hpp"

namespace carom {

/// The number of steps that comes nearest to a duration.
/// \param duration [s], from 0 up, at most 2^53 steps
/// \param dt length of a step [s], positive
/// \return how many steps
/// \throws InvalidInput if duration or dt is not as said
/// \ingroup precision
inline std::int64_t stepsUntil(Real duration, Real dt) {
  requireNonNegative(duration, "duration");
  requirePositive(dt, "dt");
  const Real steps = std::round(duration / dt);
  if (!(steps <= 0x1p53)) reject("duration", toText(duration), "must be at most 2^53 steps");
  return static_cast<std::int64_t>(steps);
}

}  // namespace carom
