#pragma once
// What must change in a tree when the box of one item changes?
//
// Method: the leaf gets the new box, and each node above it the box around its two children, up to
// the root. Nothing moves in the tree: who was whose neighbour stays it.
// Why not only grow the boxes above: after a while every box would be as large as the way that its
// items have ever been. Why not stop where a box holds the new one: it may be too large now.
// Source: van den Bergen, Journal of Graphics Tools 2(4), 1997.
// Not handled: a body that moves far away makes large boxes; then take it out and insert it again.

#include "carom/broadphase/box_tree.hpp"

namespace carom {

/// Gives a leaf another box, and all nodes above it the boxes that follow.
/// \param tree whose other boxes are as they should be; changed along one path
/// \param leaf index of a leaf of it
/// \param box its new box, low not above high [m, as the tree]
/// \ingroup broadphase
void treeRefit(BoxTree& tree, std::int32_t leaf, const Aabb<3>& box);

}  // namespace carom
