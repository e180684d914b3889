#include "carom/broadphase/sweep_and_prune.hpp"

#include <algorithm>
#include <numeric>

#include "carom/broadphase/require_box.hpp"

namespace carom {

std::vector<IndexPair> sweepAndPrune(std::span<const Aabb<3>> boxes) {
  // Given: what is no box is refused.
  for (const Aabb<3>& box : boxes) requireBox(box);
  std::vector<std::int32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return boxes[a].low.x() < boxes[b].low.x();
  });
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Aabb<3>& box = boxes[order[i]];
    // Everything that begins before this one ends.
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (boxes[order[j]].low.x() > box.high.x()) break;
      if (meets(box, boxes[order[j]])) pairs.push_back(pairOf(order[i], order[j]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace carom
