#include "carom/precision/ulp_distance.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"

namespace carom {

std::uint64_t ulpDistance(Real a, Real b) {
  if (std::isnan(a)) reject("a", toText(a), "must be a number");
  if (std::isnan(b)) reject("b", toText(b), "must be a number");
  const auto from = std::bit_cast<std::uint64_t>(a), to = std::bit_cast<std::uint64_t>(b);
  return from < to ? to - from : from - to;
}

}  // namespace carom
