// Exercise 03.aabb_overlap: do two boxes along the axes overlap, touch, or neither?
// Check it with: ./course check 03.aabb_overlap

#include "carom/detection/aabb_overlap.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Verdict aabbOverlap(const Aabb<3>& a, const Aabb<3>& b) {
  if (a.low.hasNaN() || a.high.hasNaN() || b.low.hasNaN() || b.high.hasNaN()) {
    throw InvalidInput("aabbOverlap: the corners of a box must be numbers, but one is NaN");
  }
  int touches = 0;
  for (int i = 0; i < 3; ++i) {
    // One axis on which they do not meet is enough to keep them apart.
    if (a.high(i) < b.low(i) || b.high(i) < a.low(i)) return Verdict::separated;
    if (a.high(i) == b.low(i) || b.high(i) == a.low(i)) ++touches;
  }
  return touches == 3 ? Verdict::touching : Verdict::overlapping;
}

}  // namespace carom
