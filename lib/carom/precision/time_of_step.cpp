#include "carom/precision/time_of_step.hpp"

#include <string>

#include "carom/core/checks.hpp"

namespace carom {

Real timeOfStep(std::int64_t step, Real dt, Real start) {
  requireFinite(dt, "dt");
  requireFinite(start, "start");
  constexpr std::int64_t kLast = std::int64_t{1} << 53;  // a double counts to here without a gap
  if (step > kLast || step < -kLast) reject("step", std::to_string(step), "must be within 2^53");
  return start + static_cast<Real>(step) * dt;
}

}  // namespace carom
