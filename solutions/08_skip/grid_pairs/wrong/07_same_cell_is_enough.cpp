#include "carom/broadphase/grid_pairs.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "carom/broadphase/require_box.hpp"
#include "carom/core/checks.hpp"

namespace carom {

std::vector<IndexPair> gridPairs(std::span<const Aabb<3>> boxes, Real cell) {
  // Given: what cannot be is refused.
  requirePositive(cell, "cell");
  for (const Aabb<3>& box : boxes) requireBox(box);
  const auto count = static_cast<std::int32_t>(boxes.size());
  std::map<std::array<Real, 3>, std::vector<std::int32_t>> cells;
  std::vector<std::int32_t> big;
  for (std::int32_t i = 0; i < count; ++i) {
    const Vector3 low = (boxes[i].low / cell).array().floor();
    const Vector3 high = (boxes[i].high / cell).array().floor();
    const Vector3 along = high - low + Vector3::Ones();
    if (!(along.x() * along.y() * along.z() <= 64)) {
      big.push_back(i);
      continue;
    }
    for (Real x = low.x(); x <= high.x(); ++x) {
      for (Real y = low.y(); y <= high.y(); ++y) {
        for (Real z = low.z(); z <= high.z(); ++z) cells[{x, y, z}].push_back(i);
      }
    }
  }
  std::set<IndexPair> pairs;
  const auto look = [&](std::int32_t a, std::int32_t b) {
    if (a != b) pairs.insert(pairOf(a, b));
  };
  for (const auto& [place, inside] : cells) {
    for (const std::int32_t a : inside) {
      for (const std::int32_t b : inside) look(a, b);
    }
  }
  for (const std::int32_t a : big) {
    for (std::int32_t b = 0; b < count; ++b) {
      if (meets(boxes[a], boxes[b])) look(a, b);
    }
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace carom
