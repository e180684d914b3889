#include "pair_counts.hpp"

#include <string>

#include "carom/core/errors.hpp"
#include "carom/detection/aabb_overlap.hpp"

namespace carom {

//! [measure]
std::vector<PairCount> pairCounts(std::span<const Aabb<3>> scene, std::span<const int> counts) {
  std::vector<PairCount> table;
  for (const int count : counts) {
    if (count < 0 || static_cast<std::size_t>(count) > scene.size()) {
      throw InvalidInput("pairCounts: the scene has " + std::to_string(scene.size()) +
                         " boxes, but " + std::to_string(count) + " are asked for");
    }
    PairCount row{count, 0, 0};
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) {
        ++row.asked;
        if (aabbOverlap(scene[i], scene[j]) != Verdict::separated) ++row.kept;
      }
    }
    table.push_back(row);
  }
  return table;
}
//! [measure]

}  // namespace carom
