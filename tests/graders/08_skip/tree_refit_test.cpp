// Grader of 08.tree_refit: after the move every box must be that around the leaves below it, which
// are gathered from the leaves upwards.

#include "carom/broadphase/tree_refit.hpp"

#include <limits>

#include "box_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kCopied = "sides of boxes are copied from leaves";

// The boxes of all nodes, in the order of the list.
Boxes boxesOf(const BoxTree& tree) {
  Boxes boxes;
  for (const TreeNode<3>& node : tree.nodes) boxes.push_back(node.box);
  return boxes;
}

Boxes refitted(BoxTree tree, std::int32_t leaf, const Aabb<3>& box) {
  treeRefit(tree, leaf, box);
  return boxesOf(tree);
}

// Each leaf widens all that are above it.
Boxes expected(const BoxTree& tree, std::int32_t leaf, const Aabb<3>& box) {
  const Real infinity = std::numeric_limits<Real>::infinity();
  Boxes boxes(tree.nodes.size(),
              boxFrom(Vector3::Constant(infinity), Vector3::Constant(-infinity)));
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(tree.nodes.size()); ++i) {
    if (!tree.nodes[i].isLeaf()) continue;
    const Aabb<3> own = i == leaf ? box : tree.nodes[i].box;
    for (std::int32_t up = i; up != kNone; up = tree.nodes[up].parent) {
      boxes[up].low = boxes[up].low.cwiseMin(own.low);
      boxes[up].high = boxes[up].high.cwiseMax(own.high);
    }
  }
  return boxes;
}

void ask(const BoxTree& tree, std::int32_t item, const Aabb<3>& box, const char* what) {
  const std::int32_t leaf = leafOf(tree, item);
  GRADE(refitted(tree, leaf, box), expected(tree, leaf, box), within(0, kCopied),
        given("boxes of the nodes before", boxesOf(tree), "m"), given("leaf", leaf),
        given("box", box, "m"), unit("m"), about(what));
}

Boxes row(int count) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(boxFrom({3.0 * i, 0, 0}, {3.0 * i + 1, 1, 1}));
  return boxes;
}

}  // namespace

TEST_CASE("grows") {
  ask(treeOf(row(8)), 12, boxFrom({-9, 5, 0}, {-8, 6, 1}), "the third of eight flies away");
  ask(treeOf(row(8)), 17, boxFrom({21, 0, -4}, {22, 1, -3}), "the last of eight goes down");
  ask(treeOf(row(6), true), 15, boxFrom({15, 7, 0}, {16, 8, 1}), "the last of a chain goes aside");
}

TEST_CASE("shrinks") {
  ask(treeOf(row(8)), 10, boxFrom({4, 0, 0}, {5, 1, 1}), "the first of eight moves inwards");
  ask(treeOf(row(8)), 17, boxFrom({19, 0, 0}, {20, 1, 1}), "the last of eight moves inwards");
  ask(treeOf(row(5), true), 14, boxFrom({4, 0, 0}, {5, 1, 1}), "the end of a chain moves inwards");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 8; ++n) {
    const BoxTree tree = treeOf(crowd(random, 13, 4), n % 2 == 0);
    const int item = random.integer(10, 22);
    ask(tree, item, boxAround(random.vector(5), Vector3(0.5, 0.6, 0.7)), "a tree of thirteen");
  }
}

TEST_CASE("alone") {
  ask(treeOf(row(1)), 10, boxFrom({5, 5, 5}, {6, 6, 6}), "a leaf that is the root");
}

PROBES() {
  Random random(850);
  for (int n = 0; n < 16; ++n) {
    const BoxTree tree = treeOf(crowd(random, 7, 3), n % 3 == 0);
    const Vector3 center = random.vector(n % 2 == 0 ? 4 : 1);
    PROBE(refitted(tree, leafOf(tree, 10 + n % 7), boxAround(center, Vector3(0.3, 0.4, 0.5))));
  }
}
