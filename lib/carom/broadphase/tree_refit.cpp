#include "carom/broadphase/tree_refit.hpp"

namespace carom {

void treeRefit(BoxTree& tree, std::int32_t leaf, const Aabb<3>& box) {
  std::vector<TreeNode<3>>& nodes = tree.nodes;
  nodes[leaf].box = box;
  // All the way up: each box is made anew from the two below.
  for (std::int32_t above = nodes[leaf].parent; above != kNone; above = nodes[above].parent) {
    nodes[above].box = joined(nodes[nodes[above].left].box, nodes[nodes[above].right].box);
  }
}

}  // namespace carom
