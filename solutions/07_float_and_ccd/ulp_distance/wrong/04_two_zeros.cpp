#include "carom/precision/ulp_distance.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"

namespace carom {

std::uint64_t ulpDistance(Real a, Real b) {
  if (std::isnan(a)) reject("a", toText(a), "must be a number");
  if (std::isnan(b)) reject("b", toText(b), "must be a number");
  const auto place = [](Real x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
    return bits & kSign ? ~bits : bits | kSign;
  };
  const std::uint64_t from = place(a), to = place(b);
  return from < to ? to - from : from - to;
}

}  // namespace carom
