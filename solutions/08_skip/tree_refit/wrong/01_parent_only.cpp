#include "carom/broadphase/tree_refit.hpp"

namespace carom {

void treeRefit(BoxTree& tree, std::int32_t leaf, const Aabb<3>& box) {
  std::vector<TreeNode<3>>& nodes = tree.nodes;
  nodes[leaf].box = box;
  const std::int32_t above = nodes[leaf].parent;
  if (above != kNone) {
    nodes[above].box = joined(nodes[nodes[above].left].box, nodes[nodes[above].right].box);
  }
}

}  // namespace carom
