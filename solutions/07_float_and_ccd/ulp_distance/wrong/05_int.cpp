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
    const auto size = std::bit_cast<std::int64_t>(std::abs(x));
    return std::signbit(x) ? -size : size;
  };
  return static_cast<std::uint32_t>(std::abs(place(a) - place(b)));
}

}  // namespace carom
