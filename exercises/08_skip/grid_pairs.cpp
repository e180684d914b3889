// Exercise 08.grid_pairs: which boxes meet, by the cells of a grid
// Check it with: ./course check 08.grid_pairs

#include "carom/broadphase/grid_pairs.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "carom/broadphase/require_box.hpp"
#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

std::vector<IndexPair> gridPairs(std::span<const Aabb<3>> boxes, Real cell) {
  // Given: what cannot be is refused.
  requirePositive(cell, "cell");
  for (const Aabb<3>& box : boxes) requireBox(box);
  // std::floor(x) rounds down; a std::map finds the list of a cell by its three numbers; a
  // std::set holds each pair once, in order.
  return todo<std::vector<IndexPair>>("gridPairs");
}

}  // namespace carom
