#include "carom/motion/simulate.hpp"

#include "carom/core/checks.hpp"

namespace carom {

State simulate(const Step& step, const State& state, Real time, Real dt, int steps,
               const Acceleration& acceleration) {
  if (!step) reject("step", "an empty function", "must be callable");
  if (steps < 0) reject("steps", std::to_string(steps), "must be zero or positive");
  State now = state;
  for (int i = 0; i < steps; ++i) now = step(now, time + i * dt, dt, acceleration);
  return now;
}

}  // namespace carom
