// Exercise 07.orient2d_filtered: on which side of a line is a point, without any doubt?
// Check it with: ./course check 07.orient2d_filtered

#include "carom/precision/orient2d_filtered.hpp"

#include <cmath>

#include "carom/core/todo.hpp"
#include "carom/precision/exact_orient2d.hpp"

namespace carom {

FilteredSign orient2dFiltered(const Vector2& a, const Vector2& b, const Vector2& c) {
  //# solution
  const Real left = (a.x() - c.x()) * (b.y() - c.y());
  const Real right = (a.y() - c.y()) * (b.x() - c.x());
  const Real bound = 3.0000000000000004 * 0x1p-53 * (std::abs(left) + std::abs(right));
  if (std::abs(left - right) > bound) return {left > right ? 1 : -1, true};
  return {exactOrient2d(a, b, c), false};
  //# stub
  // a.x() and a.y() are the coordinates of a, std::abs(x) is |x|, 0x1p-53 is 2^-53, and
  // {1, true} is a FilteredSign.
  //#| return todo<FilteredSign>("orient2dFiltered");
  //# end
}

}  // namespace carom
