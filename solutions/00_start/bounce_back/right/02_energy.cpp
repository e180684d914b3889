// The share of energy that is left is e².
#include <cmath>

#include "bounce_back.hpp"
#include "carom/core/checks.hpp"

namespace carom {

Real restitutionForHeight(Real dropHeight, Real returnHeight) {
  requirePositive(dropHeight, "dropHeight");
  requireNonNegative(returnHeight, "returnHeight");
  if (returnHeight > dropHeight) reject("returnHeight", toText(returnHeight), "is too high");
  const Real lost = (dropHeight - returnHeight) / dropHeight;
  return std::sqrt(1 - lost);
}

}  // namespace carom
