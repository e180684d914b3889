#pragma once
// Whole numbers of 128 bits: the exact arithmetic against which the tests of this layer check.

#include <cmath>
#include <cstdint>
#include <random>

#include "carom/core/real.hpp"
#include "carom/precision/double_double.hpp"

namespace precision_test {

__extension__ using Integer = __int128;

/// A random whole number of up to `bits` bits, 53 or fewer, of either sign.
inline carom::Real whole(std::mt19937_64& engine, int bits) {
  const auto value = static_cast<std::int64_t>(engine() >> (64 - bits));
  return static_cast<carom::Real>(engine() % 2 == 0 ? value : -value);
}

/// A double-double that is a whole number, as an integer.
inline Integer exactly(const carom::DoubleDouble& value) {
  return Integer(value.high) + Integer(value.low);
}

/// |value|, for comparing errors.
inline long double magnitude(Integer value) {
  return static_cast<long double>(value < 0 ? -value : value);
}

}  // namespace precision_test
