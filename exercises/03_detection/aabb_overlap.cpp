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
  // a.low(0) is the smallest x of A, a.high(2) its largest z.
  return todo<Verdict>("aabbOverlap");
}

}  // namespace carom
