#include "carom/broadphase/tree_query.hpp"

namespace carom {

std::vector<std::int32_t> treeQuery(const BoxTree& tree, const Aabb<3>& box) {
  std::vector<std::int32_t> found, open;
  if (tree.root != kNone) open.push_back(tree.root);
  while (!open.empty()) {
    const TreeNode<3>& node = tree.nodes[open.back()];
    open.pop_back();
    if (!meets(node.box, box)) continue;
    if (node.isLeaf()) {
      found.push_back(node.item);
    } else {
      const bool left = meets(tree.nodes[node.left].box, box);
      open.push_back(left ? node.left : node.right);
    }
  }
  return found;
}

}  // namespace carom
