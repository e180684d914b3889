#include "carom/broadphase/tree_insert.hpp"

namespace carom {

std::int32_t treeInsert(BoxTree& tree, const Aabb<3>& box, std::int32_t item) {
  const std::int32_t leaf = takeNode(tree);
  const std::int32_t parent = tree.root == kNone ? kNone : takeNode(tree);
  std::vector<TreeNode<3>>& nodes = tree.nodes;
  nodes[leaf].box = box;
  nodes[leaf].item = item;
  if (parent == kNone) return tree.root = leaf;

  // By how much surface the tree grows, at least, if the leaf goes below this node: a new
  // node will be needed, around a leaf's box, or around the new box and more.
  const Real own = halfSurface(box);
  const auto growth = [&](std::int32_t node) {
    const Real both = halfSurface(joined(nodes[node].box, box));
    return nodes[node].isLeaf() ? both : both - halfSurface(nodes[node].box) + own;
  };
  std::int32_t sibling = tree.root;
  for (int level = 0; !nodes[sibling].isLeaf(); ++level) {
    const TreeNode<3>& node = nodes[sibling];
    const Real both = halfSurface(joined(node.box, box));
    // To stop makes a new box around both; to go on makes this box larger.
    const Real goOn = both - halfSurface(node.box);
    const Real left = goOn + growth(node.left);
    const Real right = goOn + growth(node.right);
    if (both < left && both < right) break;
    // Where both ways are as good the bits of the item choose: items at one point make a bush then,
    // and not a chain.
    const bool even = (item >> level % 31 & 1) == 0;
    sibling = left < right || (left == right && even) ? node.left : node.right;
  }

  // The new node takes the place of the sibling, which goes below it.
  const std::int32_t above = nodes[sibling].parent;
  nodes[parent].parent = above;
  nodes[parent].left = sibling;
  nodes[parent].right = leaf;
  nodes[sibling].parent = nodes[leaf].parent = parent;
  if (above == kNone) {
    tree.root = parent;
  } else {
    (nodes[above].left == sibling ? nodes[above].left : nodes[above].right) = parent;
  }
  // Every box on the way up must hold the new one.
  nodes[parent].box = joined(nodes[sibling].box, box);
  for (std::int32_t up = above; up != kNone; up = nodes[up].parent) {
    nodes[up].box = joined(nodes[up].box, box);
  }
  return leaf;
}

}  // namespace carom
