#pragma once
// Do two intervals of one axis overlap, touch, or leave a gap?
//
// One number answers: the larger of the two gaps "B begins after A ends" and "A begins after B
// ends". Positive: they are apart. Zero: they touch. Negative: they overlap, and its size is the
// least that one of them has to be pushed, which for an interval inside the other is more than the
// length that they share. Both comparisons must hold for an overlap: the source joins them with OR
// (equation 23), which is false for two equal points only, and so excludes nothing.
// Not handled: empty intervals (low above high).

#include <algorithm>

#include "carom/core/real.hpp"

namespace carom {

/// All numbers from low to high, both included: what a body covers on an axis.
/// \ingroup detection
struct Interval {
  Real low = 0;   ///< smallest coordinate [m]
  Real high = 0;  ///< largest coordinate [m]
};

/// The gap between two intervals: positive apart, zero touching, negative overlapping. A negative
/// gap is minus the shortest push that parts them.
/// \param a first interval [m]
/// \param b second interval, on the same axis [m]
/// \return signed gap [m]
/// \source{23,24}
/// \erratum{5.9}
/// \erratum{5.10}
/// \erratum{5.14}
/// \ingroup detection
inline Real gapBetween(const Interval& a, const Interval& b) {
  return std::max(b.low - a.high, a.low - b.high);
}

}  // namespace carom
