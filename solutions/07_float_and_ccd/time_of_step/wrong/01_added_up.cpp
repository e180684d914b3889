#include "carom/precision/time_of_step.hpp"

#include <cmath>
#include <string>

#include "carom/core/checks.hpp"

namespace carom {

Real timeOfStep(std::int64_t step, Real dt, Real start) {
  requireFinite(dt, "dt");
  requireFinite(start, "start");
  Real t = start;
  for (std::int64_t i = 0; i < step; ++i) t += dt;
  for (std::int64_t i = 0; i > step && i > -1000; --i) t -= dt;
  return t;
}

}  // namespace carom
