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

/// A step that was tried on a way whose tolerance is for all of it. \ingroup motion
struct StepTry {
  Real length = 0;             ///< of the step, positive [s]
  Real left = 0;               ///< from the start of the step to the end, at least `length` [s]
  Real duration = 0;           ///< from the start of the way to its end, positive [s]
  Real error = 0;              ///< of the step; infinite or not a number if it went wrong [m]
  Real tolerance = 0;          ///< error allowed at the end of the way, positive [m]
  int order = 1;               ///< of the method: a step's error goes with length^(order + 1)
  bool refusedBefore = false;  ///< the step before this one was made again, and this is it
};

/// What becomes of a step that was tried. \ingroup motion
struct StepChoice {
  bool accepted = false;  ///< it is good; if not, it has to be made again
  Real wanted = 0;        ///< length of the next step, if there were no end [s]
  Real next = 0;          ///< the same as it has to be near the end; zero at the end [s]
};

/// Refuses a step that nothing can be said about. \param done any step
/// \throws InvalidInput if a length, a time, the tolerance or the order is not positive and finite,
/// less is left than the step is long, or the error is negative
/// \ingroup motion
void requireUsable(const StepTry& done);

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
