#include "carom/broadphase/sweep_and_prune.hpp"

#include <algorithm>
#include <numeric>

#include "carom/broadphase/require_box.hpp"

namespace carom {

std::vector<IndexPair> sweepAndPrune(std::span<const Aabb<3>> boxes) {
  for (const Aabb<3>& box : boxes) requireBox(box);

  std::vector<std::int32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto beginsEarlier = [&](std::int32_t a, std::int32_t b) {
    return boxes[a].low.x() < boxes[b].low.x();
  };
  std::stable_sort(order.begin(), order.end(), beginsEarlier);

  std::vector<IndexPair> pairs;
  std::vector<std::int32_t> open;
  for (const std::int32_t next : order) {
    // Who ended before this one begins meets no later one either.
    std::erase_if(open,
                  [&](std::int32_t other) { return boxes[other].high.x() < boxes[next].low.x(); });
    for (const std::int32_t other : open) {
      if (meets(boxes[other], boxes[next])) {
        pairs.push_back(pairOf(other, next));
      }
    }
    open.push_back(next);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace carom
