// Exercise 03.aabb_overlap: do two boxes along the axes overlap, touch, or neither?
// Check it with: ./course check 03.aabb_overlap

#include "carom/detection/aabb_overlap.hpp"

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Verdict aabbOverlap(const Aabb<3>& a, const Aabb<3>& b) {
  // Given: what is no box is refused.
  if (a.low.hasNaN() || a.high.hasNaN() || b.low.hasNaN() || b.high.hasNaN()) {
    throw InvalidInput("aabbOverlap: the corners of a box must be numbers, but one is NaN");
  }
  //# solution
  Verdict verdict = Verdict::overlapping;
  for (int i = 0; i < 3; ++i) {
    // One axis on which they do not meet is enough to keep them apart.
    if (a.high(i) < b.low(i) || b.high(i) < a.low(i)) return Verdict::separated;
    if (a.high(i) == b.low(i) || b.high(i) == a.low(i)) verdict = Verdict::touching;
  }
  return verdict;
  //# stub
  // a.low(0) is the smallest x of A, a.high(2) its largest z.
  //#| return todo<Verdict>("aabbOverlap");
  //# end
}

}  // namespace carom
