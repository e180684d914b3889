// Grader of 08.tree_query: trees made here, asked for boxes that are compared with all items.

#include "carom/broadphase/tree_query.hpp"

#include "box_scenes.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kWhole = "items are whole numbers";
using Items = std::vector<std::int32_t>;

// In any order, so they are sorted first.
Items answer(const BoxTree& tree, const Aabb<3>& box) {
  Items items = treeQuery(tree, box);
  std::sort(items.begin(), items.end());
  return items;
}

void ask(const Boxes& boxes, bool chain, const Aabb<3>& box, const char* what) {
  Items expected;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (haveCommonPoint(boxes[i], box)) expected.push_back(10 + static_cast<std::int32_t>(i));
  }
  GRADE(answer(treeOf(boxes, chain), box), expected, within(0, kWhole),
        given("boxes of items 10, 11, ...", boxes, "m"), given("box", box, "m"), about(what));
}

// Cubes of 1 m, 3 m from each other.
Boxes row(int count) {
  Boxes boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(boxFrom({3.0 * i, 0, 0}, {3.0 * i + 1, 1, 1}));
  return boxes;
}

}  // namespace

TEST_CASE("all") {
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Boxes boxes = crowd(random, 40, 3);
    ask(boxes, false, boxAround(random.vector(1), Vector3::Constant(1.8)), "forty boxes");
  }
  ask(row(8), false, boxFrom({-1, -1, -1}, {30, 2, 2}), "a box around all of a row");
}

TEST_CASE("across") {
  ask(row(8), false, boxFrom({9.5, -5, 0.5}, {12.5, 9, 7}), "a box across the middle of a row");
  ask(row(8), false, boxFrom({0.5, 0.5, -9}, {6.5, 0.6, 9}), "a box that is higher than the row");
}

TEST_CASE("edge") {
  ask(row(4), false, boxFrom({1, 1, 1}, {3, 2, 2}), "a box that touches two cubes at corners");
  ask(row(4), false, boxFrom({4, 0.2, 0.2}, {5, 0.4, 0.4}), "one that touches a face");
  Boxes corners = row(4);
  corners[1] = boxFrom({0, 8, 0}, {1, 9, 1});
  ask(corners, false, boxFrom({0.5, 0.5, 0.5}, {0.8, 8.5, 0.6}), "a thin one between two halves");
  ask(corners, false, boxFrom({5.5, 0.5, 0.5}, {6.5, 0.6, 0.6}),
      "one that reaches into one cube only");
}

TEST_CASE("small") {
  ask(row(1), false, boxFrom({0.5, 0.5, 0.5}, {2, 2, 2}), "a tree of one item");
  ask(row(60), true, boxFrom({100, 0, 0}, {140, 1, 1}), "a chain of sixty");
}

TEST_CASE("empty") {
  GRADE(answer(BoxTree(), boxFrom({0, 0, 0}, {1, 1, 1})), Items{}, within(0, kWhole));
}

PROBES() {
  Random random(830);
  for (int n = 0; n < 14; ++n) {
    const Boxes boxes = crowd(random, 12, 1.5);
    const Aabb<3> box = boxAround(random.vector(0.8), Vector3::Constant(0.9));
    PROBE(answer(treeOf(boxes, n % 3 == 0), box));
  }
  PROBE(answer(treeOf(row(1)), boxFrom({0.5, 0.5, 0.5}, {2, 2, 2})));
  PROBE(answer(treeOf(row(4)), boxFrom({1, 1, 1}, {3, 2, 2})));
  PROBE(answer(treeOf(row(5)), boxFrom({4, 0.2, 0.2}, {6, 0.4, 0.4})));
}
