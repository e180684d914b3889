// Does the tree find what trying all boxes finds, whatever has been done to it?

#include "carom/broadphase/tree.hpp"

#include "boxes.hpp"
#include "carom/broadphase/all_pairs.hpp"
#include "carom/broadphase/tree_insert.hpp"
#include "carom/broadphase/tree_query.hpp"
#include "carom/broadphase/tree_refit.hpp"
#include "carom/core/errors.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

// Every node knows its parent, and its box is exactly that around its children. Returns the leaves.
template <int Dim>
int checkedLeaves(const TreeNodes<Dim>& tree) {
  if (tree.root == kNone) return 0;
  REQUIRE(tree.nodes[tree.root].parent == kNone);
  int leaves = 0, wrong = 0;
  std::vector<std::int32_t> open = {tree.root};
  while (!open.empty()) {
    const std::int32_t index = open.back();
    open.pop_back();
    const TreeNode<Dim>& node = tree.nodes[index];
    if (node.isLeaf()) {
      ++leaves;
      wrong += node.item == kNone || node.right != kNone;
      continue;
    }
    const Aabb<Dim> box = joined(tree.nodes[node.left].box, tree.nodes[node.right].box);
    wrong += box.low != node.box.low || box.high != node.box.high;
    wrong += tree.nodes[node.left].parent != index || tree.nodes[node.right].parent != index;
    open.push_back(node.left);
    open.push_back(node.right);
  }
  CHECK(wrong == 0);
  return leaves;
}

std::vector<std::int32_t> found(const Tree<3>& tree, const Aabb<3>& box) {
  std::vector<std::int32_t> items;
  tree.overlap(box, [&](std::int32_t item) { items.push_back(item); });
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<IndexPair> pairsOf(const Tree<3>& tree) {
  std::vector<IndexPair> pairs;
  tree.pairs([&](std::int32_t a, std::int32_t b) { pairs.push_back(pairOf(a, b)); });
  return sorted(pairs);
}

}  // namespace

TEST_CASE("the pairs of a tree are those of all pairs, inserted or rebuilt") {
  const int scene = GENERATE(range(0, kHardScenes));
  INFO("scene " << scene);
  const std::vector<Aabb<3>> boxes = hardBoxes(scene, 300);
  const std::vector<IndexPair> expected = allPairs(boxes);
  Tree<3> tree;
  for (int i = 0; i < 300; ++i) tree.insert(i, boxes[i]);
  CHECK(checkedLeaves(tree.nodes()) == 300);
  CHECK(pairsOf(tree) == expected);
  tree.rebuild();
  CHECK(checkedLeaves(tree.nodes()) == 300);
  CHECK(pairsOf(tree) == expected);
  std::vector<IndexPair> twice;
  tree.pairs(tree, [&](std::int32_t a, std::int32_t b) {
    if (a < b) twice.push_back({a, b});
  });
  CHECK(sorted(twice) == expected);
}

TEST_CASE("the plain functions on a tree agree with trying all boxes") {
  const int scene = GENERATE(range(0, kHardScenes));
  INFO("scene " << scene);
  const std::vector<Aabb<3>> boxes = hardBoxes(scene, 120);
  BoxTree tree;
  std::vector<std::int32_t> leaves;
  for (int i = 0; i < 120; ++i) leaves.push_back(treeInsert(tree, boxes[i], i));
  CHECK(checkedLeaves(tree) == 120);
  std::vector<IndexPair> pairs;
  for (int i = 0; i < 120; ++i) {
    for (const std::int32_t item : treeQuery(tree, boxes[i])) {
      if (i < item) pairs.push_back({i, item});
    }
  }
  CHECK(sorted(pairs) == allPairs(boxes));
  // Every box changes with its neighbour's.
  std::vector<Aabb<3>> moved = boxes;
  for (int i = 0; i < 120; ++i) {
    moved[i] = boxes[(i + 1) % 120];
    treeRefit(tree, leaves[i], moved[i]);
  }
  CHECK(checkedLeaves(tree) == 120);
  pairs.clear();
  for (int i = 0; i < 120; ++i) {
    for (const std::int32_t item : treeQuery(tree, moved[i])) {
      if (i < item) pairs.push_back({i, item});
    }
  }
  CHECK(sorted(pairs) == allPairs(moved));
}

TEST_CASE("a tree in which items come, go and move finds what trying all finds") {
  Random random(5);
  Tree<3> tree;
  std::vector<Aabb<3>> boxes = gasBoxes(150, 6);
  for (int turn = 0; turn < 4000; ++turn) {
    const int item = random.integer(0, 149);
    const Vector3 way = random.vector(turn % 3 == 0 ? 4 : 0.2);
    if (!tree.contains(item)) {
      tree.insert(item, boxes[item]);
    } else if (random.integer(0, 3) == 0) {
      tree.remove(item);
    } else {
      boxes[item] = {boxes[item].low + way, boxes[item].high + way};
      tree.move(item, boxes[item]);
    }
    if (turn % 500 == 250) tree.rebuild();
    if (turn % 40 != 0) continue;
    REQUIRE(checkedLeaves(tree.nodes()) == tree.size());
    const Aabb<3> asked = boxes[random.integer(0, 149)];
    std::vector<std::int32_t> expected;
    for (int i = 0; i < 150; ++i) {
      if (tree.contains(i) && meets(boxes[i], asked)) expected.push_back(i);
    }
    REQUIRE(found(tree, asked) == expected);
  }
  CHECK(tree.work().reinserted > 0);
  CHECK(tree.work().rotated > 0);
}

TEST_CASE("many that move at once are as if each had moved alone") {
  const std::vector<Aabb<3>> boxes = gasBoxes(400, 8);
  Tree<3> together, alone;
  for (int i = 0; i < 400; ++i) {
    together.insert(i, boxes[i]);
    alone.insert(i, boxes[i]);
  }
  together.rebuild();
  Random random(9);
  std::vector<Aabb<3>> moved = boxes;
  for (const int stride : {1, 3, 100}) {
    std::vector<std::int32_t> items;
    std::vector<Aabb<3>> changed;
    for (int i = 0; i < 400; i += stride) {
      const Vector3 way = random.vector(0.5);
      moved[i] = {moved[i].low + way, moved[i].high + way};
      items.push_back(i);
      changed.push_back(moved[i]);
      alone.move(i, moved[i]);
    }
    together.move(items, changed);
    CHECK(checkedLeaves(together.nodes()) == 400);
    CHECK(pairsOf(together) == allPairs(moved));
    CHECK(pairsOf(together) == pairsOf(alone));
  }
  CHECK(together.worsening() > 1);
}

TEST_CASE("a swept box and a ray find all that trying all finds") {
  const std::vector<Aabb<3>> boxes = gasBoxes(500, 12);
  Tree<3> tree;
  for (int i = 0; i < 500; ++i) tree.insert(i, boxes[i]);
  Random random(13);
  for (int turn = 0; turn < 200; ++turn) {
    const Vector3 from = random.vector(6);
    Vector3 way = random.vector(8);
    if (turn % 3 == 0) way(turn / 3 % 3) = 0;
    const Vector3 half = turn % 2 == 0 ? Vector3(0, 0, 0) : Vector3(0.3, 0.2, 0.1);
    const Aabb<3> box{from - half, from + half};
    std::vector<std::int32_t> got;
    tree.sweep(box, way, [&](std::int32_t item) {
      got.push_back(item);
      return 1.0;
    });
    std::sort(got.begin(), got.end());
    // By many small steps: whoever is met at one of them must have been found.
    for (int i = 0; i < 500; ++i) {
      bool met = false;
      for (int k = 0; k <= 256 && !met; ++k) {
        const Vector3 step = way * (k / 256.0);
        met = meets(boxes[i], {box.low + step, box.high + step});
      }
      const bool isFound = std::binary_search(got.begin(), got.end(), i);
      if (met) CHECK(isFound);
      // And nobody that is far from the whole way.
      const Aabb<3> whole = joined(box, Aabb<3>{box.low + way, box.high + way});
      if (!meets(boxes[i], whole)) CHECK_FALSE(isFound);
    }
  }
}

TEST_CASE("a ray that is shortened looks no further than it reaches") {
  Tree<3> tree;
  for (int i = 0; i < 1000; ++i) tree.insert(i, unitBoxAt(3 * i, 0, 0));
  tree.rebuild();
  // To the first box only: its near side is half a metre from its centre.
  Real limit = 1;
  int asked = 0;
  const Vector3 way(3000, 0, 0);
  const std::int64_t visited = tree.ray({-10, 0.1, 0}, way, [&](std::int32_t item) {
    ++asked;
    limit = std::min(limit, (tree.box(item).low.x() + 10) / way.x());
    return limit;
  });
  CHECK(limit * way.x() == 9.5);
  CHECK(asked <= 2);
  CHECK(visited < 60);
}

TEST_CASE("boxes at one place make a bush and not a chain") {
  Tree<3> tree;
  for (int i = 0; i < 1024; ++i) tree.insert(i, unitBoxAt(0, 0, 0));
  int deepest = 0;
  for (const TreeNode<3>& node : tree.nodes().nodes) {
    int depth = 0;
    for (std::int32_t up = node.parent; up != kNone; up = tree.nodes().nodes[up].parent) ++depth;
    deepest = std::max(deepest, depth);
  }
  // 2^10 leaves need ten levels.
  CHECK(deepest <= 20);
}

TEST_CASE("a tree of the plane finds what a tree of space finds in a slab") {
  const std::vector<Aabb<3>> boxes = hardBoxes(3, 200);
  Tree<2> plane;
  for (int i = 0; i < 200; ++i) {
    plane.insert(i, {boxes[i].low.head<2>(), boxes[i].high.head<2>()});
  }
  const auto pairs = [&] {
    std::vector<IndexPair> got;
    plane.pairs([&](std::int32_t a, std::int32_t b) { got.push_back(pairOf(a, b)); });
    return sorted(got);
  };
  CHECK(pairs() == allPairs(boxes));
  plane.rebuild();
  CHECK(checkedLeaves(plane.nodes()) == 200);
  CHECK(pairs() == allPairs(boxes));
}

TEST_CASE("a rebuilt tree is better than one of inserts, and both are far better than a list") {
  const std::vector<Aabb<3>> boxes = gasBoxes(3000, 21);
  Tree<3> tree;
  for (int i = 0; i < 3000; ++i) tree.insert(i, boxes[i]);
  const Real inserted = tree.quality();
  tree.rebuild();
  CHECK(tree.quality() < inserted);
  std::int64_t visited = 0;
  for (const Aabb<3>& box : boxes) visited += tree.overlap(box, [](std::int32_t) {});
  CHECK(visited / 3000 < 100);
}

TEST_CASE("a tree refuses what it cannot work with, and stays as it was") {
  Tree<3> tree;
  tree.insert(2, unitBoxAt(0, 0, 0));
  Aabb<3> broken = unitBoxAt(0, 0, 0);
  broken.low.x() = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(tree.insert(3, broken), InvalidInput);
  CHECK_THROWS_AS(tree.insert(3, Aabb<3>()), InvalidInput);
  CHECK_THROWS_AS(tree.insert(2, unitBoxAt(1, 0, 0)), InvalidInput);
  CHECK_THROWS_AS(tree.insert(-1, unitBoxAt(1, 0, 0)), InvalidInput);
  CHECK_THROWS_AS(tree.move(3, unitBoxAt(1, 0, 0)), InvalidInput);
  CHECK_THROWS_AS(tree.move(2, broken), InvalidInput);
  CHECK_THROWS_AS(tree.remove(7), InvalidInput);
  CHECK_THROWS_AS(tree.box(7), InvalidInput);
  CHECK(tree.size() == 1);
  CHECK(tree.box(2).low == unitBoxAt(0, 0, 0).low);
  tree.remove(2);
  CHECK(tree.size() == 0);
  CHECK(found(tree, unitBoxAt(0, 0, 0)).empty());
  tree.rebuild();
  CHECK(tree.size() == 0);
}
