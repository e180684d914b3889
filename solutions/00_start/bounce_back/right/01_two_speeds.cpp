// The two speeds written out, with gravity.
#include <cmath>

#include "bounce_back.hpp"
#include "carom/core/errors.hpp"

namespace carom {

Real restitutionForHeight(Real dropHeight, Real returnHeight) {
  if (!(dropHeight > 0 && returnHeight >= 0 && returnHeight <= dropHeight) ||
      !std::isfinite(dropHeight)) {
    throw InvalidInput("the heights must obey 0 <= returnHeight <= dropHeight, 0 < dropHeight");
  }
  const Real g = 9.81;  // [m/s²]
  const Real before = std::sqrt(2 * g * dropHeight);
  const Real after = std::sqrt(2 * g * returnHeight);
  return after / before;
}

}  // namespace carom
