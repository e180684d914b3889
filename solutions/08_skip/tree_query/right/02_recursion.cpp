#include "carom/broadphase/tree_query.hpp"

namespace carom {
namespace {

void look(const BoxTree& tree, std::int32_t at, const Aabb<3>& box,
          std::vector<std::int32_t>& found) {
  if (at == kNone || !meets(tree.nodes[at].box, box)) return;
  if (tree.nodes[at].isLeaf()) return found.push_back(tree.nodes[at].item);
  look(tree, tree.nodes[at].left, box, found);
  look(tree, tree.nodes[at].right, box, found);
}

}  // namespace

std::vector<std::int32_t> treeQuery(const BoxTree& tree, const Aabb<3>& box) {
  std::vector<std::int32_t> found;
  look(tree, tree.root, box, found);
  return found;
}

}  // namespace carom
