// Exercise 08.sweep_and_prune: which boxes meet, by a sweep along x
// Check it with: ./course check 08.sweep_and_prune

#include "carom/broadphase/sweep_and_prune.hpp"

#include <algorithm>
#include <numeric>

#include "carom/broadphase/require_box.hpp"
#include "carom/core/todo.hpp"

namespace carom {

std::vector<IndexPair> sweepAndPrune(std::span<const Aabb<3>> boxes) {
  // Given: what is no box is refused.
  for (const Aabb<3>& box : boxes) requireBox(box);
  // std::iota(begin, end, 0) fills with 0, 1, 2, ...; std::erase_if(list, test) takes out;
  // pairOf(a, b) writes the smaller number first; meets(a, b) compares two boxes.
  return todo<std::vector<IndexPair>>("sweepAndPrune");
}

}  // namespace carom
