#include "carom/precision/ulp_distance.hpp"

#include <bit>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {
namespace {

// Doubles in increasing order become integers in increasing order; both zeros become 0.
std::int64_t place(Real value) {
  const auto size = std::bit_cast<std::int64_t>(std::abs(value));
  return std::signbit(value) ? -size : size;
}

}  // namespace

std::uint64_t ulpDistance(Real a, Real b) {
  if (std::isnan(a)) reject("a", toText(a), "must be a number");
  if (std::isnan(b)) reject("b", toText(b), "must be a number");
  const std::int64_t from = place(a), to = place(b);
  return from < to ? static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from)
                   : static_cast<std::uint64_t>(from) - static_cast<std::uint64_t>(to);
}

}  // namespace carom
