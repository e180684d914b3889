#include "carom/precision/ulp_distance.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"

namespace carom {

std::uint64_t ulpDistance(Real a, Real b) {
  if (std::isnan(a)) reject("a", toText(a), "must be a number");
  if (std::isnan(b)) reject("b", toText(b), "must be a number");
  const Real larger = std::max(std::abs(a), std::abs(b));
  const Real step = larger - std::nextafter(larger, 0.0);
  if (!(step > 0)) return 0;
  return static_cast<std::uint64_t>(std::min(std::abs(a - b) / step, 1e18));
}

}  // namespace carom
