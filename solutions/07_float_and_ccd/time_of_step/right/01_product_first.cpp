#include "carom/precision/time_of_step.hpp"

#include <cmath>
#include <string>

#include "carom/core/checks.hpp"

namespace carom {

Real timeOfStep(std::int64_t step, Real dt, Real start) {
  requireFinite(dt, "dt");
  requireFinite(start, "start");
  const auto steps = static_cast<Real>(step);
  const Real passed = steps * dt;
  return passed + start;
}

}  // namespace carom
