#include "carom/precision/time_of_step.hpp"

#include <cmath>
#include <string>

#include "carom/core/checks.hpp"

namespace carom {

Real timeOfStep(std::int64_t step, Real dt, Real start) {
  requireFinite(dt, "dt");
  requireFinite(start, "start");
  return std::fma(dt, static_cast<Real>(step), start);  // rounded once
}

}  // namespace carom
