#include "carom/precision/orient2d_filtered.hpp"

#include <cmath>

#include "carom/precision/exact_orient2d.hpp"

namespace carom {

FilteredSign orient2dFiltered(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Real left = (a.x() - c.x()) * (b.y() - c.y());
  const Real right = (a.y() - c.y()) * (b.x() - c.x());
  const Real value = left - right;
  // Two differences and a product in each term, and the last difference: 3 roundings of 2^-53, and
  // what their products add (Shewchuk's (3 + 16 eps) eps). What a product loses below the smallest
  // normal number is less than kUnderflow; one that overflows makes the bound infinite.
  constexpr Real kErrorBound = 3.0000000000000018 * 0x1p-53, kUnderflow = 1e-300;
  const Real bound = kErrorBound * (std::abs(left) + std::abs(right)) + kUnderflow;
  if (std::abs(value) > bound) return {value > 0 ? 1 : -1, true};
  return {exactOrient2d(a, b, c), false};
}

}  // namespace carom
