#include "carom/toi/tunnels.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

bool tunnels(Real lengthA, Real lengthB, Real speed, Real dt) {
  requireNonNegative(lengthA, "lengthA");
  requireNonNegative(lengthB, "lengthB");
  requireFinite(speed, "speed");
  requireNonNegative(dt, "dt");
  return std::abs(speed) * dt > lengthA + lengthB;
}

}  // namespace carom
