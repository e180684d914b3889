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
  for (FoundImpact& found : all) {
    if (found.bodyB < found.bodyA) std::swap(found.bodyA, found.bodyB);
  }
  const auto key = [](const FoundImpact& f) { return std::tuple(f.time, f.bodyA, f.bodyB); };
  std::sort(all.begin(), all.end(),
            [&](const FoundImpact& p, const FoundImpact& q) { return key(p) < key(q); });
  const auto same = [&](const FoundImpact& p, const FoundImpact& q) { return p.time == q.time; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

}  // namespace carom
