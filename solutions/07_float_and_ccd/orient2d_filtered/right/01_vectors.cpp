#include "carom/precision/orient2d_filtered.hpp"

#include <cmath>

#include "carom/precision/exact_orient2d.hpp"

namespace carom {

FilteredSign orient2dFiltered(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Vector2 u = a - c, v = b - c;
  const Real value = u.x() * v.y() - u.y() * v.x();
  const Real limit = 3.4e-16 * (std::abs(u.x() * v.y()) + std::abs(u.y() * v.x()));
  if (value > limit) return {1, true};
  if (value < -limit) return {-1, true};
  FilteredSign answer;
  answer.sign = exactOrient2d(a, b, c);
  answer.filtered = false;
  return answer;
}

}  // namespace carom
