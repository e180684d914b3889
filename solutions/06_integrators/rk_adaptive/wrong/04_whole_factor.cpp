// Exercise 06.rk_adaptive: how long may the next step be?
// Check it with: ./course check 06.rk_adaptive

#include "carom/motion/rk_adaptive.hpp"

#include <cmath>

#include "carom/motion/embedded_step.hpp"

namespace carom {

AdaptiveRun rkAdaptive(const State& state, Real time, Real end, const Tolerance& tolerance,
                       const Acceleration& acceleration) {
  // Given: what cannot be worked with is refused.
  requireUsable(state, time, end - time);
  requireUsable(tolerance);
  AdaptiveRun run = {state, time};
  Real dt = (end - time) / 100;
  while (run.time != end) {
    if (run.accepted + run.rejected == tolerance.maxSteps) {
      run.status = AdaptiveStatus::kTooManySteps;
      break;
    }
    const bool last = std::abs(end - run.time) <= std::abs(dt);
    if (last) dt = end - run.time;
    const EmbeddedStep step = embeddedStep(run.state, run.time, dt, acceleration);
    const Real ratio = errorRatio(run.state, step, tolerance.absolute, tolerance.relative);
    if (ratio <= 1) {
      run.state = step.end;
      run.time = last ? end : run.time + dt;
      ++run.accepted;
    } else {
      ++run.rejected;
    }
    dt *= stepFactor(ratio, 1);
  }
  return run;
}

}  // namespace carom
