// Exercise 08.tree_refit: what changes in a tree when a leaf moves
// Check it with: ./course check 08.tree_refit

#include "carom/broadphase/tree_refit.hpp"

#include "carom/core/todo.hpp"

namespace carom {

void treeRefit(BoxTree& tree, std::int32_t leaf, const Aabb<3>& box) {
  // tree.nodes[i] has box, parent, left and right; the root has parent == kNone.
  // joined(a, b) is the box around two boxes.
  return todo<void>("treeRefit");
}

}  // namespace carom
