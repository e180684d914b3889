#pragma once
// Which boxes meet? The plainest answer.
//
// Method: try every box with every later one: n (n - 1) / 2 comparisons.
// Why: nothing can be forgotten, so that it judges all the others; and for a few boxes nothing is
// faster. The count grows with the square of the bodies, not with their cube as the source says:
// bodies enter as pairs (erratum 5.8).
// Source: section 5.3.1 of the source.

#include <span>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// All pairs of closed boxes with a common point, by trying each pair.
/// \param boxes each with low not above high, infinite sides allowed [m, world]
/// \return pairs of indices into boxes, sorted, each once
/// \throws InvalidInput if a box holds no point or a coordinate is not a number
/// \erratum{5.8}
/// \ingroup broadphase
std::vector<IndexPair> allPairs(std::span<const Aabb<3>> boxes);

}  // namespace carom
