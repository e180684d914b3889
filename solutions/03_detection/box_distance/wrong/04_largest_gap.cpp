// Exercise 03.box_distance: the distance of two boxes along the axes, which somebody got wrong.
// Check it with: ./course check 03.box_distance

#include "box_distance.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/detection/interval.hpp"

namespace carom {

Real boxDistance(const Aabb<3>& a, const Aabb<3>& b) {
  if (a.low.hasNaN() || a.high.hasNaN() || b.low.hasNaN() || b.high.hasNaN()) {
    throw InvalidInput("boxDistance: the corners of a box must be numbers, but one is NaN");
  }
  Real squares = 0;
  for (int i = 0; i < 3; ++i) {
    // An overlap is no way to go, so it counts as zero.
    const Real gap = std::max(gapBetween({a.low(i), a.high(i)}, {b.low(i), b.high(i)}), 0.0);
    squares = std::max(squares, gap * gap);
  }
  return std::sqrt(squares);
}

}  // namespace carom
