// How much work is it to find who is near whom?
//
// Boxes of 0.5 to 1 m, 4 m^3 of room for each, in a cube that grows with their number. What is
// counted are comparisons of two boxes; in the tree also those with the boxes of nodes. Then the
// functions of this chapter look for the pairs of three scenes, and should agree.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/broadphase/all_pairs.hpp"
#include "carom/broadphase/grid_pairs.hpp"
#include "carom/broadphase/pair_grid.hpp"
#include "carom/broadphase/sorted_sweep.hpp"
#include "carom/broadphase/sweep_and_prune.hpp"
#include "carom/broadphase/tree.hpp"
#include "carom/broadphase/tree_insert.hpp"
#include "carom/broadphase/tree_query.hpp"
#include "carom/broadphase/tree_refit.hpp"
#include "carom/core/random.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Aabb;
using carom::IndexPair;
using carom::Real;
using carom::Vector3;
using Boxes = std::vector<Aabb<3>>;

Boxes crowd(int count) {
  carom::Random random(801);
  const Real reach = std::cbrt(4.0 * count) / 2;
  Boxes boxes;
  for (int i = 0; i < count; ++i) {
    const Vector3 center = random.vector(reach);
    Vector3 half;
    for (int k = 0; k < 3; ++k) half(k) = random.between(0.25, 0.5);
    boxes.push_back({center - half, center + half});
  }
  return boxes;
}

// Puts all boxes into a tree, moves them to their places, and asks for the neighbours of each.
std::size_t pairsByTree(const Boxes& before, const Boxes& boxes) {
  carom::BoxTree tree;
  std::vector<std::int32_t> leaves;
  const auto count = static_cast<std::int32_t>(boxes.size());
  for (std::int32_t i = 0; i < count; ++i) {
    leaves.push_back(carom::treeInsert(tree, before[i], i));
  }
  for (std::int32_t i = 0; i < count; ++i) {
    if (boxes[i].low != before[i].low) carom::treeRefit(tree, leaves[i], boxes[i]);
  }
  std::size_t pairs = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    for (const std::int32_t other : carom::treeQuery(tree, boxes[i])) pairs += i < other;
  }
  return pairs;
}

void tellPairs(carom::io::Table& table, const std::string& scene, const Boxes& before,
               const Boxes& boxes) {
  const auto number = [](std::size_t n) { return static_cast<Real>(n); };
  table.row({scene, number(carom::allPairs(boxes).size()),
             number(carom::sweepAndPrune(boxes).size()), number(carom::gridPairs(boxes, 1).size()),
             number(pairsByTree(before, boxes))});
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";

  carom::io::Table table;
  for (const char* title : {"boxes", "pairs", "all pairs", "sweep", "grid", "tree", "a box"}) {
    table.column(title, carom::io::fixed(0));
  }
  std::vector<Real> counts;
  std::vector<std::vector<Real>> work(4);
  for (int count = 100; count <= 25600; count *= 4) {
    const Boxes boxes = crowd(count);
    //! [count]
    std::int64_t pairs = 0;
    const auto found = [&](std::int32_t, std::int32_t) { ++pairs; };
    carom::SortedSweep sweep;
    sweep.update(boxes);
    const std::int64_t bySweep = sweep.pairs(found);
    //! [count]
    carom::PairGrid grid;
    grid.update(boxes);
    const std::int64_t byGrid = grid.pairs([](std::int32_t, std::int32_t) {});
    carom::Tree<3> tree;
    for (std::int32_t i = 0; i < count; ++i) tree.insert(i, boxes[i]);
    tree.rebuild();
    const std::int64_t byTree = tree.pairs([](std::int32_t, std::int32_t) {});
    const Real all = 0.5 * count * (count - 1);
    counts.push_back(count);
    const std::vector<Real> row = {all, Real(bySweep), Real(byGrid), Real(byTree)};
    for (std::size_t k = 0; k < 4; ++k) work[k].push_back(row[k]);
    table.row({Real(count), Real(pairs), row[0], row[1], row[2], row[3], row[3] / count});
  }
  std::cout << "Comparisons of boxes\n\n" << table << '\n';

  carom::io::Table agree;
  agree.column("scene").column("all pairs", carom::io::fixed(0));
  for (const char* title : {"sweep", "grid", "tree"}) agree.column(title, carom::io::fixed(0));
  const Boxes gas = crowd(400);
  tellPairs(agree, "400 boxes", gas, gas);
  Boxes moved = gas;
  for (std::size_t i = 0; i < moved.size(); i += 2) {
    const Vector3 way(0.4, i % 4 ? 0.3 : -0.3, 0);
    moved[i] = {gas[i].low + way, gas[i].high + way};
  }
  tellPairs(agree, "half of them moved", gas, moved);
  Boxes floor = gas;
  floor.push_back({Vector3(-50, -50, -1), Vector3(50, 50, 0)});
  tellPairs(agree, "with a floor of 100 m", floor, floor);
  std::cout << "Pairs that the functions of this chapter find\n\n" << agree;

  carom::io::Plot plot("Comparisons to find all pairs");
  plot.describe(
      "Comparisons over the number of boxes, both logarithmic. All pairs rise with the square, the "
      "sweep with the power 5/3, grid and tree nearly in proportion.");
  plot.xAxis("boxes", carom::io::Scale::Logarithmic);
  plot.yAxis("comparisons", carom::io::Scale::Logarithmic).size(760, 460);
  const std::vector<std::string> names = {"all pairs", "sweep", "grid", "tree"};
  for (std::size_t k = 0; k < 4; ++k) plot.curve(names[k], counts, work[k], {.marks = true});
  plot.slope("n", 1, 2000, 3000);
  plot.writeSvg(folder / "pairs_against_n.svg");
}
