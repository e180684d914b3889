#include "carom/broadphase/tree_insert.hpp"

namespace carom {

std::int32_t treeInsert(BoxTree& tree, const Aabb<3>& box, std::int32_t item) {
  // Given: the new leaf, and a place for the node that will be above it.
  const std::int32_t leaf = takeNode(tree);
  const std::int32_t parent = tree.root == kNone ? kNone : takeNode(tree);
  std::vector<TreeNode<3>>& nodes = tree.nodes;
  nodes[leaf].box = box;
  nodes[leaf].item = item;
  if (parent == kNone) return tree.root = leaf;
  // The place for which all boxes together have the least surface, by trying each.
  std::int32_t sibling = tree.root;
  Real least = -1;
  std::vector<std::int32_t> open = {tree.root};
  while (!open.empty()) {
    const std::int32_t at = open.back();
    open.pop_back();
    Real cost = halfSurface(joined(nodes[at].box, box));
    for (std::int32_t up = nodes[at].parent; up != kNone; up = nodes[up].parent) {
      cost += halfSurface(joined(nodes[up].box, box)) - halfSurface(nodes[up].box);
    }
    if (least < 0 || cost < least) {
      least = cost;
      sibling = at;
    }
    if (nodes[at].isLeaf()) continue;
    open.push_back(nodes[at].right);
    open.push_back(nodes[at].left);
  }

  TreeNode<3>& fresh = nodes[parent];
  fresh.parent = nodes[sibling].parent;
  fresh.left = leaf;
  fresh.right = sibling;
  if (fresh.parent == kNone) {
    tree.root = parent;
  } else if (nodes[fresh.parent].left == sibling) {
    nodes[fresh.parent].left = parent;
  } else {
    nodes[fresh.parent].right = parent;
  }
  nodes[leaf].parent = nodes[sibling].parent = parent;
  for (std::int32_t up = parent; up != kNone; up = nodes[up].parent) {
    nodes[up].box = joined(nodes[nodes[up].left].box, nodes[nodes[up].right].box);
  }
  return leaf;
}

}  // namespace carom
