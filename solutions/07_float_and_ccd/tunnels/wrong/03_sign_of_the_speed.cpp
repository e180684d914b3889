// Exercise 07.tunnels: can a body jump over another one between two pictures?
// Check it with: ./course check 07.tunnels

#include "carom/toi/tunnels.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

bool tunnels(Real lengthA, Real lengthB, Real speed, Real dt) {
  // Given: what cannot be is refused.
  requireNonNegative(lengthA, "lengthA");
  requireNonNegative(lengthB, "lengthB");
  requireFinite(speed, "speed");
  requireNonNegative(dt, "dt");
  return speed * dt > lengthA + lengthB;
}

}  // namespace carom
