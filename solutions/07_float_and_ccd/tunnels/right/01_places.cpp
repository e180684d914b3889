// By the places of the front from which the bodies overlap, and those before and after a jump.
#include "carom/toi/tunnels.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

bool tunnels(Real lengthA, Real lengthB, Real speed, Real dt) {
  requireNonNegative(lengthA, "lengthA");
  requireNonNegative(lengthB, "lengthB");
  requireFinite(speed, "speed");
  requireNonNegative(dt, "dt");
  // A's front is at 0 when it gets to B, and both are rid of each other when it is at `clear`.
  const Real clear = lengthA + lengthB;
  const Real jump = speed < 0 ? -speed * dt : speed * dt;
  const bool canBeSeenForCertain = jump <= clear;
  return !canBeSeenForCertain;
}

}  // namespace carom
