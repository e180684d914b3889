#include "carom/precision/ulp_distance.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"

namespace carom {

std::uint64_t ulpDistance(Real a, Real b) {
  if (std::isnan(a)) reject("a", toText(a), "must be a number");
  if (std::isnan(b)) reject("b", toText(b), "must be a number");
  return static_cast<std::uint64_t>(std::abs(a - b) / std::numeric_limits<Real>::epsilon());
}

}  // namespace carom
