// Exercise 08.tree_query: which items of a tree meet a box
// Check it with: ./course check 08.tree_query

#include "carom/broadphase/tree_query.hpp"

#include "carom/core/todo.hpp"

namespace carom {

std::vector<std::int32_t> treeQuery(const BoxTree& tree, const Aabb<3>& box) {
  //# solution
  std::vector<std::int32_t> found, open;
  if (tree.root != kNone) open.push_back(tree.root);
  while (!open.empty()) {
    const TreeNode<3>& node = tree.nodes[open.back()];
    open.pop_back();
    if (!meets(node.box, box)) continue;
    if (node.isLeaf()) {
      found.push_back(node.item);
    } else {
      open.push_back(node.left);
      open.push_back(node.right);
    }
  }
  return found;
  //# stub
  // tree.nodes[tree.root] is the node above all others, if tree.root != kNone; a node has box,
  // left, right, item and isLeaf(). meets(a, b) compares two boxes; touching counts.
  //#| return todo<std::vector<std::int32_t>>("treeQuery");
  //# end
}

}  // namespace carom
