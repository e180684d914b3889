#pragma once
// How good is a method that turns a body step by step?
//
// Let it turn a body whose way is known, over the same time in more and more steps, and look how
// far it is off at the end. The error of a method of order p falls as dt^p: on two logarithmic axes
// its points lie on a line of slope p. Each run begins anew, the time of a step is counted as i dt
// and not added up, and the error is the angle between two orientations, read with an arctangent so
// that an error of 1e-12 rad can be seen. What it does not show: errors that cancel at the end of a
// period.

#include <functional>
#include <span>
#include <vector>

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// One step of a method: from the orientation at a time [s] to the one a step [s] later.
/// \ingroup rotation
using TurningStep = std::function<Quaternion(const Quaternion& q, Real time, Real dt)>;

/// What came out of one run. \ingroup rotation
struct TurningError {
  int steps = 0;   ///< how many steps the run had
  Real dt = 0;     ///< the length of each [s]
  Real error = 0;  ///< angle between where the body is and where it should be [rad]
};

/// The error of a method at the end of a known motion, for several counts of steps.
/// \param step the method; called with times 0, dt, 2 dt, ...
/// \param start orientation at time 0, body to world; any norm but zero
/// \param end orientation at the end, which is known exactly; any norm but zero
/// \param duration how long the motion takes [s]
/// \param counts how many steps each run makes, each at least 1
/// \return a row for each count, in the same order
/// \throws InvalidInput if a count is below 1, the duration is not finite, or an orientation is
/// none
/// \ingroup rotation
std::vector<TurningError> turningErrors(const TurningStep& step, const Quaternion& start,
                                        const Quaternion& end, Real duration,
                                        std::span<const int> counts);

}  // namespace carom
