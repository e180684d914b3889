#include "bounce_back.hpp"

#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {

//! [restitution]
Real restitutionForHeight(Real dropHeight, Real returnHeight) {
  requirePositive(dropHeight, "dropHeight");
  requireNonNegative(returnHeight, "returnHeight");
  if (returnHeight > dropHeight) {
    reject("returnHeight", toText(returnHeight),
           "must not exceed dropHeight " + toText(dropHeight));
  }
  // v² = 2 g h before and after, so e = v1/v0 = sqrt(h1/h0).
  return std::sqrt(returnHeight / dropHeight);
}
//! [restitution]

}  // namespace carom
