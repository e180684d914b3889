// Do all ways of finding pairs find the same ones?

#include "boxes.hpp"
#include "carom/broadphase/all_pairs.hpp"
#include "carom/broadphase/broad_phase.hpp"
#include "carom/broadphase/grid_pairs.hpp"
#include "carom/broadphase/pair_grid.hpp"
#include "carom/broadphase/sorted_sweep.hpp"
#include "carom/broadphase/sweep_and_prune.hpp"
#include "carom/broadphase/tree.hpp"
#include "carom/core/errors.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

std::vector<IndexPair> bySortedSweep(SortedSweep& sweep, const std::vector<Aabb<3>>& boxes) {
  std::vector<IndexPair> pairs;
  sweep.update(boxes);
  sweep.pairs([&](std::int32_t a, std::int32_t b) { pairs.push_back({a, b}); });
  return sorted(pairs);
}

std::vector<IndexPair> byGrid(PairGrid& grid, const std::vector<Aabb<3>>& boxes) {
  std::vector<IndexPair> pairs;
  grid.update(boxes);
  grid.pairs([&](std::int32_t a, std::int32_t b) { pairs.push_back({a, b}); });
  return sorted(pairs);
}

}  // namespace

TEST_CASE("all ways find the pairs of all pairs, in scenes that are hard on them") {
  const int scene = GENERATE(range(0, kHardScenes));
  INFO("scene " << scene);
  const std::vector<Aabb<3>> boxes = hardBoxes(scene, 300);
  const std::vector<IndexPair> expected = allPairs(boxes);
  CHECK(sweepAndPrune(boxes) == expected);
  SortedSweep sweep;
  CHECK(bySortedSweep(sweep, boxes) == expected);
  PairGrid grid;
  CHECK(byGrid(grid, boxes) == expected);
  for (const Real cell : {1e-3, 0.7, 1.0, 50.0, 1e35}) CHECK(gridPairs(boxes, cell) == expected);
}

TEST_CASE("what stays from step to step finds the same pairs as what begins anew") {
  std::vector<Aabb<3>> boxes = gasBoxes(300, 3);
  SortedSweep sweep;
  PairGrid grid;
  Random random(4);
  for (int step = 0; step < 60; ++step) {
    for (Aabb<3>& box : boxes) {
      // Slowly; in one step far, in another the scene is pulled along one axis.
      const Vector3 way = random.vector(step == 30 ? 9 : 0.05);
      box = {box.low + way, box.high + way};
      if (step == 40) box.low.y() = 40 * box.low.y(), box.high.y() = box.low.y() + 0.5;
    }
    const std::vector<IndexPair> expected = allPairs(boxes);
    REQUIRE(bySortedSweep(sweep, boxes) == expected);
    REQUIRE(byGrid(grid, boxes) == expected);
  }
  CHECK(sweep.axis() == 1);
  // At the start, when all jumped, when the axis changed.
  CHECK(sweep.sorts() <= 4);
}

TEST_CASE("a sort that stays sorted takes few exchanges") {
  std::vector<Aabb<3>> boxes = gasBoxes(1000, 5);
  SortedSweep sweep;
  sweep.update(boxes);
  sweep.update(boxes);
  CHECK(sweep.exchanges() == 0);
  for (Aabb<3>& box : boxes) box = {box.low + Vector3::Ones(), box.high + Vector3::Ones()};
  sweep.update(boxes);
  CHECK(sweep.exchanges() == 0);
  CHECK(sweep.sorts() == 1);
}

TEST_CASE("the grid keeps a continent out of its cells") {
  std::vector<Aabb<3>> boxes = gasBoxes(500, 6);
  boxes.push_back({Vector3(-1e6, -1e6, -1), Vector3(1e6, 1e6, 0)});
  PairGrid grid;
  CHECK(byGrid(grid, boxes) == allPairs(boxes));
  CHECK(grid.bigBoxes() == 1);
  CHECK(grid.cell() < 2);
}

TEST_CASE("D16: the pairs of 1000 and of 20000 boxes, counted exactly") {
  const json expected = readCase("broadphase", "D16");
  for (const json& scene : expected["scenes"]) {
    const auto boxes =
        caseBoxes(scene["boxes"].get<int>(), scene["world"].get<int>(), scene["size"].get<int>());
    const auto closed = scene["closed"].get<std::size_t>();
    const std::vector<IndexPair> pairs = sweepAndPrune(boxes);
    CHECK(pairs.size() == closed);
    std::size_t strict = 0;
    for (const IndexPair& pair : pairs) {
      const Aabb<3>&a = boxes[pair.first], &b = boxes[pair.second];
      strict += (a.high.array() > b.low.array()).all() && (b.high.array() > a.low.array()).all();
    }
    CHECK(strict == scene["strict"].get<std::size_t>());
    CHECK(gridPairs(boxes, scene["size"].get<int>()) == pairs);
    SortedSweep sweep;
    CHECK(bySortedSweep(sweep, boxes) == pairs);
    PairGrid grid;
    CHECK(byGrid(grid, boxes) == pairs);
    Tree<3> tree;
    BroadPhase phase({.margin = 0});
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(boxes.size()); ++i) {
      tree.insert(i, boxes[i]);
      phase.add(i, boxes[i], Mobility::moving);
    }
    std::vector<IndexPair> met;
    tree.pairs([&](std::int32_t i, std::int32_t j) { met.push_back(pairOf(i, j)); });
    CHECK(sorted(met) == pairs);
    phase.update();
    CHECK(phase.pairs().sorted() == pairs);
    // Trying all of the larger scene takes as long as all else here together.
    if (boxes.size() < 2000) CHECK(allPairs(boxes) == pairs);
  }
}

TEST_CASE("bodies enter as pairs: n of them at one place are n (n - 1) / 2 pairs") {
  for (const std::size_t n : {1u, 2u, 10u, 200u}) {
    const std::vector<Aabb<3>> boxes(n, unitBoxAt(1, 2, 3));
    CHECK(allPairs(boxes).size() == n * (n - 1) / 2);
  }
}

TEST_CASE("a box that is none is refused by every way") {
  for (const Real bad : {std::numeric_limits<Real>::quiet_NaN(), Real(-3)}) {
    std::vector<Aabb<3>> boxes = gasBoxes(5, 1);
    boxes[3] = unitBoxAt(0, 0, 0);
    boxes[3].high.y() = bad;
    CHECK_THROWS_AS(allPairs(boxes), InvalidInput);
    CHECK_THROWS_AS(sweepAndPrune(boxes), InvalidInput);
    CHECK_THROWS_AS(gridPairs(boxes, 1), InvalidInput);
  }
  const std::vector<Aabb<3>> boxes = gasBoxes(5, 1);
  CHECK_THROWS_AS(gridPairs(boxes, 0), InvalidInput);
  CHECK_THROWS_AS(gridPairs(boxes, std::numeric_limits<Real>::quiet_NaN()), InvalidInput);
  CHECK(allPairs({}).empty());
  CHECK(sweepAndPrune({}).empty());
  CHECK(gridPairs({}, 1).empty());
}
