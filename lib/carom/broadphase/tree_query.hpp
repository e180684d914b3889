#pragma once
// Which items of a tree meet a box?
//
// Method: from the root downwards. A node whose box does not meet the asked one is dropped with all
// that is below; one that does gives its item, or its two children to be looked at.
// Why a list of open nodes and no recursion: a tree can be as deep as it has items.
// Source: Goldsmith and Salmon, 1987; Ericson, Real-Time Collision Detection, 2005, chapter 6.
// Not handled: asking without taking memory, rays, swept boxes (tree.hpp).

#include "carom/broadphase/box_tree.hpp"

namespace carom {

/// The items whose closed boxes have a point in common with a box.
/// \param tree any tree, also an empty one
/// \param box low not above high [m, as the tree]
/// \return items, each once, in any order
/// \ingroup broadphase
std::vector<std::int32_t> treeQuery(const BoxTree& tree, const Aabb<3>& box);

}  // namespace carom
