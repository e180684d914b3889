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
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return boxes[a].low.x() < boxes[b].low.x(); });
  std::vector<IndexPair> pairs;
  std::vector<std::int32_t> open;
  for (std::int32_t place = 0; place < static_cast<std::int32_t>(order.size()); ++place) {
    const std::int32_t next = order[place];
    std::erase_if(open,
                  [&](std::int32_t other) { return boxes[other].high.x() < boxes[next].low.x(); });
    for (const std::int32_t other : open) {
      if (!meets(boxes[other], boxes[next])) continue;
      const auto at = std::find(order.begin(), order.end(), other) - order.begin();
      pairs.push_back(pairOf(static_cast<std::int32_t>(at), place));
    }
    open.push_back(next);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace carom
