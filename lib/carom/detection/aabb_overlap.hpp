#pragma once
// Do two boxes with sides along the axes overlap, touch, or neither?
//
// Method: two intervals overlap if each starts before the other ends: both comparisons must hold.
// Boxes overlap if their intervals do on all three axes; they touch if they meet on all three and
// merely touch on at least one.
// Why not the source's rule: its equation (23) joins the comparisons by OR, which is true for any
// two intervals but equal points and throws no pair out; its equation (24) calls boxes touching
// that are metres apart on another axis.
// Source: equations 23 and 24, corrected.
// Not handled: boxes without a point (low above high) meet nothing.

#include "carom/detection/aabb.hpp"
#include "carom/detection/verdict.hpp"

namespace carom {

/// How two closed axis-aligned boxes stand to each other.
/// \param a one box, low not above high [m, world]
/// \param b another box, low not above high [m, world]
/// \return separated, touching (common points, but no common volume) or overlapping
/// \throws InvalidInput if a coordinate is not a number
/// \source{23,24}
/// \erratum{5.9,5.10}
/// \ingroup detection
Verdict aabbOverlap(const Aabb<3>& a, const Aabb<3>& b);

}  // namespace carom
