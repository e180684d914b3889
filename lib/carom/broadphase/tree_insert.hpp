#pragma once
// Where in a tree does a new item belong?
//
// Method: walk down from the root, at each node into the child whose box has to grow less to take
// the new one in (measured in surface: how likely a box is to be met goes with its surface, not
// with its volume), and stop where it is cheaper to become the neighbour of the whole node. There a
// new node takes the place, with the old one and the new leaf below it; all boxes above grow.
// Why surface: a long thin box has nearly no volume, and is met by everything that crosses it.
// Source: Goldsmith and Salmon, 1987; the descent as in Box2D (Catto, 2009 and GDC 2019).
// Not handled: keeping the tree good over many inserts (rotations in tree.hpp).

#include "carom/broadphase/box_tree.hpp"

namespace carom {

/// Puts an item into a tree.
/// \param tree any tree, also an empty one; gets a leaf and, if it was not empty, a node above it
/// \param box of the item, low not above high [m]
/// \param item what the leaf will hold, not yet in the tree
/// \return index of the new leaf
/// \ingroup broadphase
std::int32_t treeInsert(BoxTree& tree, const Aabb<3>& box, std::int32_t item);

}  // namespace carom
