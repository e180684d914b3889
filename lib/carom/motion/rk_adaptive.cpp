#include "carom/motion/rk_adaptive.hpp"

#include <cmath>

#include "carom/motion/embedded_step.hpp"

namespace carom {

AdaptiveRun rkAdaptive(const State& state, Real time, Real end, const Tolerance& tolerance,
                       const Acceleration& acceleration) {
  requireUsable(state, time, end - time);
  requireUsable(tolerance);

  AdaptiveRun run = {state, time};
  Real dt = (end - time) / 100;  // a guess: the first steps put it right
  while (run.time != end) {
    if (run.accepted + run.rejected == tolerance.maxSteps) {
      run.status = AdaptiveStatus::kTooManySteps;
      break;
    }
    // The last step ends on the dot, and the one before it leaves no crumb.
    const bool last = std::abs(end - run.time) <= 1.01 * std::abs(dt);
    if (last) dt = end - run.time;
    if (!last && run.time + dt / 10 == run.time) {
      run.status = AdaptiveStatus::kStepTooSmall;
      break;
    }

    const EmbeddedStep step = embeddedStep(run.state, run.time, dt, acceleration);
    const Real ratio = errorRatio(run.state, step, tolerance.absolute, tolerance.relative);
    if (ratio <= 1) {
      run.state = step.end;
      run.time = last ? end : run.time + dt;
      ++run.accepted;
    } else {
      ++run.rejected;
    }
    dt *= stepFactor(ratio, 5);
  }
  return run;
}

}  // namespace carom
