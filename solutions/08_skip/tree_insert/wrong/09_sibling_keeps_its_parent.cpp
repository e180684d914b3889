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
  const auto growth = [&](std::int32_t node) {
    return halfSurface(joined(nodes[node].box, box)) - halfSurface(nodes[node].box);
  };
  std::int32_t sibling = tree.root;
  while (!nodes[sibling].isLeaf()) {
    const TreeNode<3>& node = nodes[sibling];
    const std::int32_t best = growth(node.left) <= growth(node.right) ? node.left : node.right;
    // Beside this node a new box is needed around both; further down this one and the next grow.
    const Real beside = halfSurface(joined(node.box, box));
    const Real below = halfSurface(joined(nodes[best].box, box));
    if (beside <= growth(sibling) + below) break;
    sibling = best;
  }

  const std::int32_t above = nodes[sibling].parent;
  nodes[parent].parent = above;
  nodes[parent].left = sibling;
  nodes[parent].right = leaf;
  nodes[parent].box = joined(nodes[sibling].box, box);
  nodes[leaf].parent = parent;
  if (above == kNone) {
    tree.root = parent;
  } else {
    (nodes[above].left == sibling ? nodes[above].left : nodes[above].right) = parent;
  }
  for (std::int32_t up = above; up != kNone; up = nodes[up].parent) {
    nodes[up].box = joined(nodes[up].box, box);
  }
  return leaf;
}

}  // namespace carom
