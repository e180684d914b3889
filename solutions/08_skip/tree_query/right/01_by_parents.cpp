#include "carom/broadphase/tree_query.hpp"

namespace carom {

std::vector<std::int32_t> treeQuery(const BoxTree& tree, const Aabb<3>& box) {
  std::vector<std::int32_t> found;
  std::int32_t at = tree.root;
  while (at != kNone) {
    const TreeNode<3>& node = tree.nodes[at];
    const bool met = meets(node.box, box);
    if (met && !node.isLeaf()) {
      at = node.left;
      continue;
    }
    if (met) found.push_back(node.item);
    // Up, until there is a right child that has not been seen.
    std::int32_t above = node.parent;
    while (above != kNone && tree.nodes[above].right == at) {
      at = above;
      above = tree.nodes[at].parent;
    }
    at = above == kNone ? kNone : tree.nodes[above].right;
  }
  return found;
}

}  // namespace carom
