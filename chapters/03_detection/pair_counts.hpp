#pragma once
// How many pairs of bodies have to be looked at closely?
//
// Method: of n boxes each is compared once with each other one, and the pairs that are not apart
// are counted.
// Why: the work of a scene grows with the pairs, n (n - 1) / 2, not with the bodies, and not with
// their cube as the source says; the test of boxes leaves few of them for the costly tests, but the
// comparisons themselves remain (chapter 8 skips most of those too).
// Source: section 5.3.1 of the source text, its cost put right.
// Not handled: asking fewer pairs.

#include <span>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// Pairs among the first few boxes of a scene. \ingroup detection
struct PairCount {
  int boxes = 0;  ///< how many boxes
  int asked = 0;  ///< pairs that were compared, each pair once
  int kept = 0;   ///< pairs that touch or overlap
};

/// Counts the pairs among the first boxes of a scene.
/// \param scene boxes, low not above high [m, world]
/// \param counts how many of them to take, each not negative and at most the size of the scene
/// \return one row for each count, in the order given
/// \throws InvalidInput if a count is negative or larger than the scene
/// \erratum{5.8}
/// \ingroup detection
std::vector<PairCount> pairCounts(std::span<const Aabb<3>> scene, std::span<const int> counts);

}  // namespace carom
