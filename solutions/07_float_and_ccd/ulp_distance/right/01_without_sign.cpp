#include "carom/precision/ulp_distance.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "carom/core/checks.hpp"

namespace carom {

std::uint64_t ulpDistance(Real a, Real b) {
  if (std::isnan(a)) reject("a", toText(a), "must be a number");
  if (std::isnan(b)) reject("b", toText(b), "must be a number");
  // Positive numbers above the middle, negative ones mirrored below it.
  constexpr std::uint64_t kMiddle = std::uint64_t{1} << 63;
  std::uint64_t places[2] = {};
  const Real numbers[2] = {a, b};
  for (int i = 0; i < 2; ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(numbers[i]);
    places[i] = bits & kMiddle ? kMiddle - (bits & ~kMiddle) : kMiddle + bits;
  }
  return places[0] > places[1] ? places[0] - places[1] : places[1] - places[0];
}

}  // namespace carom
