#pragma once
// What is asked of a method that chooses its steps, and what it answers.

#include "carom/motion/state.hpp"

namespace carom {

/// What a method that chooses its steps has to reach. \ingroup motion
struct Tolerance {
  Real relative = 1e-9;   ///< error allowed per step, as a share of each coordinate [1]
  Real absolute = 1e-9;   ///< error allowed per step where a coordinate is near zero [m and m/s]
  int maxSteps = 100000;  ///< tries, accepted or not, before it gives up
};

/// Refuses a tolerance that cannot be worked with. \param tolerance any tolerance
/// \throws InvalidInput if `absolute` is not positive and finite, `relative` negative or not
/// finite, or `maxSteps` not positive
/// \ingroup motion
void requireUsable(const Tolerance& tolerance);

/// The factor by which the next step should differ from this one: nine tenths of what would just
/// do, and no change by more than five times at once.
/// \param ratio error of this step in units of what is allowed; zero or positive, also infinite
/// \param order power of the step with which that error goes, positive
/// \return 0.9 / ratio^(1/order), between 1/5 and 5; the same bits on every machine
/// \throws InvalidInput if the order is not positive
/// \ingroup motion
Real stepFactor(Real ratio, int order);

/// How a run with chosen steps ended. \ingroup motion
enum class AdaptiveStatus {
  kReachedEnd,    ///< the state is that at the end
  kStepTooSmall,  ///< no step that the clock can show is short enough: a collision, or a jump
  kTooManySteps,  ///< Tolerance::maxSteps were not enough
};

/// Where a run with chosen steps came to. \ingroup motion
struct AdaptiveRun {
  State state;                                          ///< positions and velocities at `time`
  Real time = 0;                                        ///< how far it came [s]
  AdaptiveStatus status = AdaptiveStatus::kReachedEnd;  ///< why it stopped
  int accepted = 0;                                     ///< steps made
  int rejected = 0;                                     ///< steps tried and thrown away
};

}  // namespace carom
