// Exercise 08.tree_insert: where in a tree does a new item belong?
// Check it with: ./course check 08.tree_insert

#include "carom/broadphase/tree_insert.hpp"

#include "carom/core/todo.hpp"

namespace carom {

std::int32_t treeInsert(BoxTree& tree, const Aabb<3>& box, std::int32_t item) {
  // Given: the new leaf, and a place for the node that will be above it.
  const std::int32_t leaf = takeNode(tree);
  const std::int32_t parent = tree.root == kNone ? kNone : takeNode(tree);
  std::vector<TreeNode<3>>& nodes = tree.nodes;
  nodes[leaf].box = box;
  nodes[leaf].item = item;
  if (parent == kNone) return tree.root = leaf;
  // Find the sibling: walk down from tree.root. Then the node `parent` takes its place.
  // halfSurface(box) and joined(a, b) are given; nodes[i].isLeaf() says when there is no way down.
  // The last line, which returns the leaf, is given too.
  return todo<std::int32_t>("treeInsert");
  return leaf;
}

}  // namespace carom
