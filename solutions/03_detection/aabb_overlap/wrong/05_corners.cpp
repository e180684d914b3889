// Exercise 03.aabb_overlap: do two boxes along the axes overlap, touch, or neither?
// Check it with: ./course check 03.aabb_overlap

#include "carom/detection/aabb_overlap.hpp"

#include "carom/core/errors.hpp"

namespace carom {

Verdict aabbOverlap(const Aabb<3>& a, const Aabb<3>& b) {
  if (a.low.hasNaN() || a.high.hasNaN() || b.low.hasNaN() || b.high.hasNaN()) {
    throw InvalidInput("aabbOverlap: the corners of a box must be numbers, but one is NaN");
  }
  Verdict verdict = Verdict::overlapping;
  for (int i = 0; i < 3; ++i) {
    // One axis on which they do not meet is enough to keep them apart.
    if (a.high(i) < b.low(i) || b.high(i) < a.low(i)) return Verdict::separated;
    if (a.high(i) == b.low(i) || b.high(i) == a.low(i)) verdict = Verdict::touching;
  }
  bool corner = false;
  for (int n = 0; n < 8; ++n) {
    bool ofA = true;
    bool ofB = true;
    for (int i = 0; i < 3; ++i) {
      const Real x = (n >> i) & 1 ? a.high(i) : a.low(i);
      const Real y = (n >> i) & 1 ? b.high(i) : b.low(i);
      ofA = ofA && x >= b.low(i) && x <= b.high(i);
      ofB = ofB && y >= a.low(i) && y <= a.high(i);
    }
    corner = corner || ofA || ofB;
  }
  if (!corner) return Verdict::separated;
  return verdict;
}

}  // namespace carom
