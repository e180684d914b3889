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
    // Numbers of cells without a sign.
    Vector3 low, high;
    for (int k = 0; k < 3; ++k) {
      low(k) = static_cast<std::uint32_t>(static_cast<int>(boxes[i].low(k) / cell));
      high(k) = static_cast<std::uint32_t>(static_cast<int>(boxes[i].high(k) / cell));
      if (!(std::abs(boxes[i].low(k)) < 1e6 && std::abs(boxes[i].high(k)) < 1e6)) {
        low(k) = 0;
        high(k) = 1000;
      }
    }
    const Vector3 along = high - low + Vector3::Ones();
    if (along.minCoeff() > 0 && !(along.x() * along.y() * along.z() <= 64)) {
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
    if (a != b && meets(boxes[a], boxes[b])) pairs.insert(pairOf(a, b));
  };
  for (const auto& [place, inside] : cells) {
    for (const std::int32_t a : inside) {
      for (const std::int32_t b : inside) look(a, b);
    }
  }
  for (const std::int32_t a : big) {
    for (std::int32_t b = 0; b < count; ++b) look(a, b);
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace carom
