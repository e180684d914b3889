#include "carom/precision/orient2d_filtered.hpp"

#include <cmath>

#include "carom/precision/exact_orient2d.hpp"

namespace carom {

FilteredSign orient2dFiltered(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Real left = (a.x() - c.x()) * (b.y() - c.y());
  const Real right = (a.y() - c.y()) * (b.x() - c.x());
  const Real value = left - right;
  // Two differences and a product in each term, and the last difference: 3 roundings of 2^-53, and
  // what their products add. Below 1e-280 the products may have lost digits beyond that.
  const Real size = std::abs(left) + std::abs(right);
  constexpr Real kErrorBound = 3.0000000000000004 * 0x1p-53;
  if (std::abs(value) > kErrorBound * size && size > 1e-280 && size < 1e300) {
    return {value > 0 ? 1 : -1, true};
  }
  return {exactOrient2d(a, b, c), false};
}

}  // namespace carom
