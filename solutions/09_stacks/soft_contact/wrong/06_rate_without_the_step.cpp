#include "carom/solver/soft_contact.hpp"

#include <numbers>

#include "carom/core/checks.hpp"

namespace carom {

SoftContact softContact(Real frequency, Real dampingRatio, Real dt) {
  requirePositive(frequency, "frequency");
  requireNonNegative(dampingRatio, "dampingRatio");
  requirePositive(dt, "dt");
  const Real w = 2 * std::numbers::pi * frequency;
  const Real stiff = dt * w * (2 * dampingRatio + dt * w);
  return {dampingRatio > 0 ? w / (2 * dampingRatio) : w, stiff / (1 + stiff), 1 / (1 + stiff)};
}

}  // namespace carom
