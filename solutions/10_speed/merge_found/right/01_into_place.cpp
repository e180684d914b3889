#include "merge_found.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "carom/core/checks.hpp"

namespace carom {

std::vector<FoundImpact> mergeFound(std::span<const std::vector<FoundImpact>> lists) {
  std::vector<FoundImpact> all;
  for (const std::vector<FoundImpact>& list : lists) {
    for (const FoundImpact& found : list) {
      requireFinite(found.time, "time");
      if (found.bodyA == found.bodyB) {
        reject("impact", std::to_string(found.bodyA) + " with itself", "must be of two bodies");
      }
      all.push_back(found);
    }
  }
  std::vector<FoundImpact> sorted;
  for (const FoundImpact& one : all) {
    const auto [low, high] = std::minmax(one.bodyA, one.bodyB);
    const auto key = std::tuple(one.time, low, high);
    std::size_t at = 0;
    bool known = false;
    while (at < sorted.size() && !known) {
      const auto other = std::tuple(sorted[at].time, sorted[at].bodyA, sorted[at].bodyB);
      known = key == other;
      if (key < other) break;
      ++at;
    }
    const FoundImpact named = {one.time, std::get<1>(key), std::get<2>(key)};
    if (!known) sorted.insert(sorted.begin() + static_cast<std::ptrdiff_t>(at), named);
  }
  all = sorted;
  return all;
}

}  // namespace carom
