// Grader of 08.tree_insert: what is left of the tree is looked at from outside. The best surface is
// found by trying every place.

#include "carom/broadphase/tree_insert.hpp"

#include "box_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kCounted = "these are counted";
constexpr const char* kRounding = "roundings of a sum of areas";

BoxTree inserted(BoxTree tree, const Boxes& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    treeInsert(tree, boxes[i], 50 + static_cast<std::int32_t>(i));
  }
  return tree;
}

// Is a node's number one of the tree's?
bool isNode(const BoxTree& tree, std::int32_t node) {
  return node >= 0 && node < static_cast<std::int32_t>(tree.nodes.size());
}

// The items that a walk from the root comes to, while every box holds that of the node below it;
// no further than there are nodes.
std::vector<std::int32_t> reached(const BoxTree& tree) {
  std::vector<std::int32_t> items, open;
  if (isNode(tree, tree.root)) open.push_back(tree.root);
  for (std::size_t n = 0; !open.empty() && n < 2 * tree.nodes.size(); ++n) {
    const TreeNode<3>& node = tree.nodes[open.back()];
    open.pop_back();
    if (node.isLeaf()) {
      items.push_back(node.item);
      continue;
    }
    for (const std::int32_t child : {node.left, node.right}) {
      if (!isNode(tree, child)) continue;
      const Aabb<3>& box = tree.nodes[child].box;
      const bool held = (node.box.low.array() <= box.low.array()).all() &&
                        (node.box.high.array() >= box.high.array()).all();
      if (held) open.push_back(child);
    }
  }
  std::sort(items.begin(), items.end());
  return items;
}

// The parent of each item's leaf, of its parent and so on, as a walk down from the root says; the
// number of those that disagree with the links upwards comes last.
std::vector<int> links(const BoxTree& tree) {
  int nodes = 0, wrong = isNode(tree, tree.root) ? tree.nodes[tree.root].parent != kNone : 1;
  std::vector<std::int32_t> open;
  if (isNode(tree, tree.root)) open.push_back(tree.root);
  for (std::size_t n = 0; !open.empty() && n < 2 * tree.nodes.size(); ++n) {
    const std::int32_t at = open.back();
    open.pop_back();
    ++nodes;
    if (tree.nodes[at].isLeaf()) continue;
    for (const std::int32_t child : {tree.nodes[at].left, tree.nodes[at].right}) {
      if (!isNode(tree, child)) {
        ++wrong;
        continue;
      }
      wrong += tree.nodes[child].parent != at;
      open.push_back(child);
    }
  }
  return {nodes, wrong};
}

Real half(const Vector3& edges) {
  return edges.x() * edges.y() + edges.y() * edges.z() + edges.z() * edges.x();
}

// Half of the surface of all boxes above leaves, each made from the leaves below it.
Real surface(const BoxTree& tree) {
  std::vector<Aabb<3>> boxes(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (!tree.nodes[i].isLeaf()) continue;
    std::size_t steps = 0;
    for (std::int32_t up = tree.nodes[i].parent; isNode(tree, up) && steps < 2 * tree.nodes.size();
         up = tree.nodes[up].parent, ++steps) {
      boxes[up].low = boxes[up].low.cwiseMin(tree.nodes[i].box.low);
      boxes[up].high = boxes[up].high.cwiseMax(tree.nodes[i].box.high);
    }
  }
  Real sum = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (!tree.nodes[i].isLeaf()) sum += half(boxes[i].high - boxes[i].low);
  }
  return sum;
}

Real surfaceWith(const BoxTree& tree, const Aabb<3>& box) {
  return surface(inserted(tree, {box}));
}

// The least surface, by trying each node as the sibling.
Real leastSurface(const BoxTree& tree, const Aabb<3>& box) {
  const auto around = [&](std::int32_t node) {
    const Aabb<3>& own = tree.nodes[node].box;
    return half(own.high.cwiseMax(box.high) - own.low.cwiseMin(box.low));
  };
  Real least = 1e300;
  for (std::int32_t at = 0; at < static_cast<std::int32_t>(tree.nodes.size()); ++at) {
    Real sum = surface(tree) + around(at);
    for (std::int32_t up = tree.nodes[at].parent; up != kNone; up = tree.nodes[up].parent) {
      sum += around(up) - half(tree.nodes[up].box.high - tree.nodes[up].box.low);
    }
    least = std::min(least, sum);
  }
  return least;
}

std::vector<std::int32_t> itemsOf(std::size_t old, std::size_t fresh) {
  std::vector<std::int32_t> items;
  for (std::size_t i = 0; i < old; ++i) items.push_back(10 + static_cast<std::int32_t>(i));
  for (std::size_t i = 0; i < fresh; ++i) items.push_back(50 + static_cast<std::int32_t>(i));
  return items;
}

void askHolds(const Boxes& before, const Boxes& fresh, const char* what) {
  GRADE(reached(inserted(treeOf(before), fresh)), itemsOf(before.size(), fresh.size()),
        within(0, kCounted), given("boxes of items 10, 11, ...", before, "m"),
        given("boxes of items 50, 51, ...", fresh, "m"), about(what));
}

void askLinks(const Boxes& before, const Boxes& fresh, const char* what) {
  const std::vector<int> expected = {2 * static_cast<int>(before.size() + fresh.size()) - 1, 0};
  GRADE(links(inserted(treeOf(before), fresh)), expected, within(0, kCounted),
        given("boxes of items 10, 11, ...", before, "m"),
        given("boxes of items 50, 51, ...", fresh, "m"),
        unit("(nodes from the root down, links that disagree)"), about(what));
}

void askPlace(const Boxes& before, const Aabb<3>& box, const char* what) {
  const BoxTree tree = treeOf(before);
  GRADE(surfaceWith(tree, box), leastSurface(tree, box), withinRelative(1e-12, kRounding),
        given("boxes of items 10, 11, ...", before, "m"), given("box", box, "m"), unit("m^2"),
        about(what));
}

// Two crowds of four cubes, at -50 m and at 50 m.
Boxes twoCrowds() {
  Boxes boxes;
  for (const Real middle : {-50.0, 50.0}) {
    for (int i = 0; i < 4; ++i)
      boxes.push_back(boxFrom({middle + 3 * i, 0, 0}, {middle + 3 * i + 1, 1, 1}));
  }
  return boxes;
}

}  // namespace

TEST_CASE("holds") {
  askHolds(twoCrowds(), {boxFrom({-49, 4, 0}, {-48, 5, 1})}, "one above the left crowd");
  askHolds(twoCrowds(), {boxFrom({53.2, 0, -7}, {53.8, 1, -6})}, "one below the right crowd");
  Random random(seed());
  for (int n = 0; n < 3; ++n) askHolds(crowd(random, 9, 4), crowd(random, 12, 6), "twelve to nine");
}

TEST_CASE("linked") {
  askLinks({boxFrom({0, 0, 0}, {1, 1, 1})}, {boxFrom({5, 0, 0}, {6, 1, 1})}, "a second item");
  Random random(seed());
  for (int n = 0; n < 3; ++n) askLinks(crowd(random, 5, 4), crowd(random, 9, 6), "nine to five");
}

TEST_CASE("place") {
  askPlace(twoCrowds(), boxFrom({-44.1, 0.1, 0.1}, {-43.2, 0.9, 0.9}), "in the left crowd");
  askPlace(twoCrowds(), boxFrom({53.1, 0.1, 0.1}, {53.9, 0.9, 0.9}), "in the right crowd");
  askPlace(twoCrowds(), boxFrom({0, 3000, 0}, {1, 3001, 1}), "far from all others");
  askPlace(twoCrowds(), boxFrom({50, 40, 40}, {59, 49, 49}), "a large one beside the right crowd");
}

TEST_CASE("flat") {
  Boxes flat = twoCrowds();
  for (Aabb<3>& box : flat) box.high.z() = box.low.z() = 0;
  askPlace(flat, boxFrom({53.1, 0.1, 0}, {53.9, 0.9, 0}), "flat boxes, one more on the right");
  askPlace(flat, boxFrom({-46.9, 0.1, 0}, {-46.1, 0.9, 0}), "flat boxes, one more on the left");
}

TEST_CASE("first") {
  GRADE(reached(inserted(BoxTree(), {boxFrom({0, 0, 0}, {1, 1, 1})})), itemsOf(0, 1),
        within(0, kCounted));
}

PROBES() {
  Random random(840);
  for (int n = 0; n < 8; ++n) {
    const BoxTree tree = treeOf(crowd(random, 6, 4));
    const Boxes fresh = crowd(random, 2, 7);
    PROBE(reached(inserted(tree, fresh)));
    PROBE(links(inserted(tree, fresh)));
    PROBE(surface(inserted(tree, fresh)));
  }
  Boxes flat = twoCrowds();
  for (Aabb<3>& box : flat) box.high.z() = box.low.z() = 0;
  PROBE(surfaceWith(treeOf(flat), boxFrom({53.1, 0.1, 0}, {53.9, 0.9, 0})));
  PROBE(surfaceWith(treeOf(twoCrowds()), boxFrom({0, 3000, 0}, {1, 3001, 1})));
}
