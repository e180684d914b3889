// With a factor of its own, another first step, and time left in place of time gone.
#include <algorithm>
#include <cmath>

#include "carom/motion/embedded_step.hpp"
#include "carom/motion/rk_adaptive.hpp"

namespace carom {

AdaptiveRun rkAdaptive(const State& state, Real time, Real end, const Tolerance& tolerance,
                       const Acceleration& acceleration) {
  requireUsable(state, time, end - time);
  requireUsable(tolerance);
  AdaptiveRun run;
  run.state = state;
  run.time = time;
  Real dt = (end - time) / 1000;
  for (int tries = 0; run.time != end; ++tries) {
    if (tries == tolerance.maxSteps) {
      run.status = AdaptiveStatus::kTooManySteps;
      return run;
    }
    const Real left = end - run.time;
    const bool arrives = std::abs(dt) >= std::abs(left) / 1.000001;
    const Real h = arrives ? left : dt;
    const EmbeddedStep step = embeddedStep(run.state, run.time, h, acceleration);
    const Real ratio = errorRatio(run.state, step, tolerance.absolute, tolerance.relative);
    const Real factor = ratio == 0 ? 4 : std::clamp(0.85 * std::pow(ratio, -0.2), 0.1, 4.0);
    dt = h * factor;
    if (!(ratio <= 1)) {
      ++run.rejected;
      continue;
    }
    ++run.accepted;
    run.state = step.end;
    run.time = arrives ? end : run.time + h;
  }
  return run;
}

}  // namespace carom
