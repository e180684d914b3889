// The counts from triangular numbers, the pairs from the upper half of a table.
#include "carom/core/errors.hpp"
#include "carom/detection/aabb_overlap.hpp"
#include "pair_counts.hpp"

namespace carom {

std::vector<PairCount> pairCounts(std::span<const Aabb<3>> scene, std::span<const int> counts) {
  std::vector<PairCount> table;
  for (const int n : counts) {
    if (n < 0 || static_cast<std::size_t>(n) > scene.size()) throw InvalidInput("too many boxes");
    PairCount row;
    row.boxes = n;
    row.asked = n * (n - 1) / 2;
    for (int j = n - 1; j > 0; --j) {
      for (int i = 0; i < j; ++i) {
        row.kept += aabbOverlap(scene[i], scene[j]) == Verdict::separated ? 0 : 1;
      }
    }
    table.push_back(row);
  }
  return table;
}

}  // namespace carom
