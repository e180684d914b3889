#include "carom/solver/soft_contact.hpp"

#include <numbers>

#include "carom/core/checks.hpp"

namespace carom {

SoftContact softContact(Real frequency, Real dampingRatio, Real dt) {
  requirePositive(frequency, "frequency");
  requireNonNegative(dampingRatio, "dampingRatio");
  requirePositive(dt, "dt");
  // For a mass of 1 kg: stiffness k, damper c, and what Smith (2004) calls CFM and ERP.
  const Real w = 2 * std::numbers::pi * frequency;
  const Real k = w * w;
  const Real c = 2 * dampingRatio * w;
  const Real softness = 1 / (dt * (dt * k + c));
  const Real rate = k / (dt * k + c);
  return {rate, 1 / (1 + softness), softness / (1 + softness)};
}

}  // namespace carom
