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
  const auto number = [&](Real x) { return std::floor(x / cell); };
  struct Entry {
    Real x, y, z;
    std::int32_t box;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  std::vector<IndexPair> pairs;
  for (std::int32_t i = 0; i < count; ++i) {
    const Aabb<3>& box = boxes[i];
    const Real x0 = number(box.low.x()), y0 = number(box.low.y()), z0 = number(box.low.z());
    const Real nx = number(box.high.x()) - x0, ny = number(box.high.y()) - y0;
    const Real nz = number(box.high.z()) - z0;
    if (!((nx + 1) * (ny + 1) * (nz + 1) <= 64)) {
      for (std::int32_t b = 0; b < count; ++b) {
        if (b != i && meets(boxes[b], box)) pairs.push_back(pairOf(i, b));
      }
      continue;
    }
    for (Real x = 0; x <= nx; ++x) {
      for (Real y = 0; y <= ny; ++y) {
        for (Real z = 0; z <= nz; ++z) entries.push_back({x0 + x, y0 + y, z0 + z, i});
      }
    }
  }
  std::sort(entries.begin(), entries.end());
  for (auto a = entries.begin(); a != entries.end(); ++a) {
    for (auto b = a + 1; b != entries.end(); ++b) {
      if (b->x != a->x || b->y != a->y || b->z != a->z) break;
      if (meets(boxes[a->box], boxes[b->box])) pairs.push_back({a->box, b->box});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace carom
