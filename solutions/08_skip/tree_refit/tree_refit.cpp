// Exercise 08.tree_refit: what changes in a tree when a leaf moves
// Check it with: ./course check 08.tree_refit

#include "carom/broadphase/tree_refit.hpp"

#include "carom/core/todo.hpp"

namespace carom {

void treeRefit(BoxTree& tree, std::int32_t leaf, const Aabb<3>& box) {
  //# solution
  std::vector<TreeNode<3>>& nodes = tree.nodes;
  nodes[leaf].box = box;
  for (std::int32_t above = nodes[leaf].parent; above != kNone; above = nodes[above].parent) {
    nodes[above].box = joined(nodes[nodes[above].left].box, nodes[nodes[above].right].box);
  }
  //# stub
  // tree.nodes[i] has box, parent, left and right; the root has parent == kNone.
  // joined(a, b) is the box around two boxes.
  //#| return todo<void>("treeRefit");
  //# end
}

}  // namespace carom
