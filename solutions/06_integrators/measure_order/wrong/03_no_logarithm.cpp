// Exercise 06.measure_order: of which order is a method, as measured?
// Check it with: ./course check 06.measure_order

#include "carom/motion/measure_order.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real measureOrder(const StepError& coarse, const StepError& fine) {
  // Given: what cannot be measured is refused.
  requirePositive(coarse.dt, "coarse.dt");
  requirePositive(fine.dt, "fine.dt");
  requirePositive(coarse.error, "coarse.error");
  requirePositive(fine.error, "fine.error");
  if (!(coarse.dt > fine.dt)) reject("fine.dt", toText(fine.dt), "must be below coarse.dt");
  return (coarse.error / fine.error) / (coarse.dt / fine.dt);
}

}  // namespace carom
