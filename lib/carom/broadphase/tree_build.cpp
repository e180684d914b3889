#include "carom/broadphase/tree_build.hpp"

#include <array>
#include <utility>

namespace carom {
namespace {

constexpr int kBins = 8;  // more find hardly better cuts; fewer are hardly faster

// Twice the centre; infinite sides count as far away, so that no infinity meets its opposite.
template <int Dim>
Real centerOf(const Aabb<Dim>& box, int axis) {
  return std::max(box.low(axis), Real(-1e100)) + std::min(box.high(axis), Real(1e100));
}

// The axis on which the centres are spread most, from where and how far.
struct Spread {
  int axis = 0;
  Real low = 0, width = 0;
};

template <int Dim>
Spread spreadOf(const BoxedItem<Dim>* begin, const BoxedItem<Dim>* end) {
  std::array<Real, Dim> low, high;
  for (int k = 0; k < Dim; ++k) low[k] = high[k] = centerOf(begin->box, k);
  for (const BoxedItem<Dim>* at = begin + 1; at != end; ++at) {
    for (int k = 0; k < Dim; ++k) {
      const Real center = centerOf(at->box, k);
      low[k] = std::min(low[k], center);
      high[k] = std::max(high[k], center);
    }
  }
  Spread spread;
  for (int k = 0; k < Dim; ++k) {
    if (high[k] - low[k] > spread.width) spread = {k, low[k], high[k] - low[k]};
  }
  return spread;
}

// Puts the items of the left half first; returns where the right half begins.
template <int Dim>
BoxedItem<Dim>* cut(BoxedItem<Dim>* begin, BoxedItem<Dim>* end) {
  const auto count = end - begin;
  const Spread spread = spreadOf(begin, end);
  // All centres at one point (or too near for a bin to have a width): any half is as good.
  const Real scale = kBins * (1 - 0x1p-50) / spread.width;
  if (count == 2 || !(scale > 0) || !(scale < 1e300)) return begin + count / 2;
  const auto binOf = [&](const BoxedItem<Dim>& item) {
    return static_cast<int>((centerOf(item.box, spread.axis) - spread.low) * scale);
  };

  std::array<Aabb<Dim>, kBins> boxes;
  std::array<Real, kBins> counts = {};
  for (const BoxedItem<Dim>* at = begin; at != end; ++at) {
    const int bin = binOf(*at);
    boxes[bin] = joined(boxes[bin], at->box);
    counts[bin] += 1;
  }
  // The cost of all that is right of each cut, from the right; then the left ones beside it.
  std::array<Real, kBins> right = {};
  Aabb<Dim> box;
  Real sum = 0;
  for (int bin = kBins - 1; bin > 0; --bin) {
    if (counts[bin] > 0) box = joined(box, boxes[bin]);
    sum += counts[bin];
    right[bin] = sum > 0 ? sum * halfSurface(box) : 0;
  }
  int best = 0;
  Real least = 0;
  box = Aabb<Dim>();
  sum = 0;
  for (int bin = 0; bin + 1 < kBins; ++bin) {
    if (counts[bin] > 0) box = joined(box, boxes[bin]);
    sum += counts[bin];
    // The first and the last bin are never empty, so neither half is.
    const Real cost = sum * halfSurface(box) + right[bin + 1];
    if (bin == 0 || cost < least) {
      least = cost;
      best = bin;
    }
  }
  BoxedItem<Dim>* last = end;
  while (begin != last) {
    if (binOf(*begin) <= best) {
      ++begin;
    } else {
      std::swap(*begin, *--last);
    }
  }
  return begin;
}

}  // namespace

template <int Dim>
void buildTree(std::vector<BoxedItem<Dim>>& items, TreeNodes<Dim>& tree, BuildScratch& scratch) {
  const auto count = static_cast<std::int32_t>(items.size());
  tree.root = tree.free = kNone;
  tree.nodes.clear();
  if (count == 0) return;
  tree.root = 0;
  tree.nodes.reserve(2 * items.size() - 1);
  scratch.open.assign(1, {0, count, kNone, false});
  while (!scratch.open.empty()) {
    const BuildScratch::Range range = scratch.open.back();
    scratch.open.pop_back();
    const auto node = static_cast<std::int32_t>(tree.nodes.size());
    tree.nodes.emplace_back();
    tree.nodes[node].parent = range.parent;
    if (range.parent != kNone) {
      (range.isRight ? tree.nodes[range.parent].right : tree.nodes[range.parent].left) = node;
    }
    if (range.end - range.begin == 1) {
      tree.nodes[node].box = items[range.begin].box;
      tree.nodes[node].item = items[range.begin].item;
      continue;
    }
    const auto middle = static_cast<std::int32_t>(
        cut(items.data() + range.begin, items.data() + range.end) - items.data());
    scratch.open.push_back({middle, range.end, node, true});
    scratch.open.push_back({range.begin, middle, node, false});
  }
  // Children come behind their parents, so backwards every box finds those below it done.
  for (auto node = tree.nodes.rbegin(); node != tree.nodes.rend(); ++node) {
    if (!node->isLeaf())
      node->box = joined(tree.nodes[node->left].box, tree.nodes[node->right].box);
  }
}

template void buildTree(std::vector<BoxedItem<2>>& items, TreeNodes<2>& tree,
                        BuildScratch& scratch);
template void buildTree(std::vector<BoxedItem<3>>& items, TreeNodes<3>& tree,
                        BuildScratch& scratch);

}  // namespace carom
