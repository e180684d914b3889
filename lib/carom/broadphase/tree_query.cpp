#include "carom/broadphase/tree_query.hpp"

namespace carom {

std::vector<std::int32_t> treeQuery(const BoxTree& tree, const Aabb<3>& box) {
  std::vector<std::int32_t> found, open;
  if (tree.root != kNone) open.push_back(tree.root);
  while (!open.empty()) {
    const TreeNode<3>& node = tree.nodes[open.back()];
    open.pop_back();
    // Who misses a box misses all that is in it.
    if (!meets(node.box, box)) continue;
    if (node.isLeaf()) {
      found.push_back(node.item);
    } else {
      open.push_back(node.left);
      open.push_back(node.right);
    }
  }
  return found;
}

}  // namespace carom
