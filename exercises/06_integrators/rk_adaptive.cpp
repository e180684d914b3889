// Exercise 06.rk_adaptive: how long may the next step be?
// Check it with: ./course check 06.rk_adaptive

#include "carom/motion/rk_adaptive.hpp"

#include <cmath>

#include "carom/core/todo.hpp"
#include "carom/motion/embedded_step.hpp"

namespace carom {

AdaptiveRun rkAdaptive(const State& state, Real time, Real end, const Tolerance& tolerance,
                       const Acceleration& acceleration) {
  // Given: what cannot be worked with is refused.
  requireUsable(state, time, end - time);
  requireUsable(tolerance);
  // AdaptiveRun run = {state, time}; is where it begins; (end - time) / 100 will do as a first dt.
  // Given are embeddedStep, errorRatio (embedded_step.hpp) and stepFactor (adaptive.hpp).
  // If run.accepted + run.rejected has come to tolerance.maxSteps, stop there and set run.status to
  // AdaptiveStatus::kTooManySteps. That also ends a loop that would never end.
  return todo<AdaptiveRun>("rkAdaptive");
}

}  // namespace carom
