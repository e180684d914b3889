// Exercise 03.pair_counts: how the work grows with the number of bodies.
// Check it with: ./course check 03.pair_counts

#include "pair_counts.hpp"

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"
#include "carom/detection/aabb_overlap.hpp"

namespace carom {

std::vector<PairCount> pairCounts(std::span<const Aabb<3>> scene, std::span<const int> counts) {
  // Given: more boxes than the scene has are refused.
  for (const int count : counts) {
    if (count < 0 || static_cast<std::size_t>(count) > scene.size()) {
      throw InvalidInput("pairCounts: a count must be from 0 to the size of the scene");
    }
  }
  // One row for each count: the first `count` boxes of the scene, each pair of them once.
  // aabbOverlap(a, b) gives a verdict.
  return todo<std::vector<PairCount>>("pairCounts");
}

}  // namespace carom
