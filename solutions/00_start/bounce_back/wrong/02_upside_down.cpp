#include "bounce_back.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

Real restitutionForHeight(Real dropHeight, Real returnHeight) {
  requirePositive(dropHeight, "dropHeight");
  requireNonNegative(returnHeight, "returnHeight");
  if (returnHeight > dropHeight) {
    reject("returnHeight", toText(returnHeight),
           "must not exceed dropHeight " + toText(dropHeight));
  }
  return std::sqrt(dropHeight / returnHeight);
}

}  // namespace carom
