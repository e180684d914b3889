// The slope of the line through both points on paper with logarithmic axes.
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/motion/measure_order.hpp"

namespace carom {

Real measureOrder(const StepError& coarse, const StepError& fine) {
  const auto usable = [](const StepError& run) {
    return run.dt > 0 && run.error > 0 && std::isfinite(run.dt) && std::isfinite(run.error);
  };
  if (!usable(coarse) || !usable(fine) || !(coarse.dt > fine.dt)) throw InvalidInput("no pair");
  const Real up = std::log10(coarse.error) - std::log10(fine.error);
  const Real along = std::log10(coarse.dt) - std::log10(fine.dt);
  return up / along;
}

}  // namespace carom
