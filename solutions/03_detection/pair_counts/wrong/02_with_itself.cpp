// Exercise 03.pair_counts: how the work grows with the number of bodies.
// Check it with: ./course check 03.pair_counts

#include "pair_counts.hpp"

#include "carom/core/errors.hpp"
#include "carom/detection/aabb_overlap.hpp"

namespace carom {

std::vector<PairCount> pairCounts(std::span<const Aabb<3>> scene, std::span<const int> counts) {
  for (const int count : counts) {
    if (count < 0 || static_cast<std::size_t>(count) > scene.size()) {
      throw InvalidInput("pairCounts: a count must be from 0 to the size of the scene");
    }
  }
  std::vector<PairCount> table;
  for (const int count : counts) {
    PairCount row{count, 0, 0};
    for (int i = 0; i < count; ++i) {
      for (int j = i; j < count; ++j) {
        ++row.asked;
        if (aabbOverlap(scene[i], scene[j]) != Verdict::separated) ++row.kept;
      }
    }
    table.push_back(row);
  }
  return table;
}

}  // namespace carom
