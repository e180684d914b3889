#include "carom/broadphase/tree_refit.hpp"

namespace carom {

void treeRefit(BoxTree& tree, std::int32_t leaf, const Aabb<3>& box) {
  tree.nodes[leaf].box = box;
  std::int32_t above = tree.nodes[leaf].parent;
  while (above != kNone) {
    TreeNode<3>& node = tree.nodes[above];
    const Aabb<3> fresh = joined(tree.nodes[node.left].box, tree.nodes[node.right].box);
    // Then nothing further up changes either.
    if (fresh.low == node.box.low && fresh.high == node.box.high) return;
    node.box = fresh;
    above = node.parent;
  }
}

}  // namespace carom
