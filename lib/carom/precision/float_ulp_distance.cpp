#include "carom/precision/float_ulp_distance.hpp"

#include <bit>
#include <cmath>

#include "carom/core/checks.hpp"

namespace carom {
namespace {

std::int64_t place(float value) {
  const std::int64_t size = std::bit_cast<std::int32_t>(std::abs(value));
  return std::signbit(value) ? -size : size;
}

}  // namespace

std::uint32_t floatUlpDistance(float a, float b) {
  if (std::isnan(a)) reject("a", toText(Real(a)), "must be a number");
  if (std::isnan(b)) reject("b", toText(Real(b)), "must be a number");
  return static_cast<std::uint32_t>(std::abs(place(a) - place(b)));
}

}  // namespace carom
