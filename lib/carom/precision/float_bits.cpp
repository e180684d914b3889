#include "carom/precision/float_bits.hpp"

#include <cmath>

namespace carom {
namespace {

std::string digits(std::uint64_t number, int count) {
  std::string text;
  for (int i = count - 1; i >= 0; --i) text += (number >> i) & 1 ? '1' : '0';
  return text;
}

}  // namespace

Real valueOf(const FloatBits& bits) {
  const Real sign = bits.negative ? -1 : 1;
  if (bits.kind == NumberKind::infinite) return sign * std::numeric_limits<Real>::infinity();
  if (bits.kind == NumberKind::notANumber) return std::numeric_limits<Real>::quiet_NaN();
  const std::uint64_t first = bits.kind == NumberKind::normal ? 1 : 0;  // the digit not stored
  const std::uint64_t all = (first << bits.fractionBits) + bits.fraction;
  return sign * std::ldexp(static_cast<Real>(all), bits.exponent - bits.fractionBits);
}

std::string bitText(const FloatBits& bits) {
  const auto power = static_cast<std::uint64_t>(bits.storedPower);
  return std::string(bits.negative ? "1 " : "0 ") + digits(power, bits.powerBits) + ' ' +
         digits(bits.fraction, bits.fractionBits);
}

const char* kindName(NumberKind kind) {
  switch (kind) {
    case NumberKind::zero:
      return "zero";
    case NumberKind::subnormal:
      return "subnormal";
    case NumberKind::normal:
      return "normal";
    case NumberKind::infinite:
      return "infinite";
    case NumberKind::notANumber:
      break;
  }
  return "not a number";
}

}  // namespace carom
