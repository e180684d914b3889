#include "carom/broadphase/grid_pairs.hpp"

#include <algorithm>
#include <array>

#include "carom/broadphase/require_box.hpp"
#include "carom/core/checks.hpp"

namespace carom {
namespace {

constexpr Real kMostCells = 64;     // more make a box a big one
constexpr Real kLastCell = 0x1p52;  // beyond it, neighbours have one number

// A box in one of its cells.
struct Entry {
  std::array<Real, 3> cell;
  std::int32_t box;
  friend auto operator<=>(const Entry&, const Entry&) = default;
};

std::array<Real, 3> cellOf(const Vector3& point, Real cell) {
  // Down, not towards zero: the cell -1 is as large as the others.
  return {std::floor(point.x() / cell), std::floor(point.y() / cell), std::floor(point.z() / cell)};
}

// Enters a box into its cells; false if they are too many.
bool enter(std::int32_t index, const Aabb<3>& box, Real cell, std::vector<Entry>& entries) {
  const std::array<Real, 3> low = cellOf(box.low, cell), high = cellOf(box.high, cell);
  Real cells = 1;
  for (int k = 0; k < 3; ++k) {
    if (low[k] < -kLastCell || high[k] > kLastCell) return false;
    cells *= high[k] - low[k] + 1;
  }
  if (cells > kMostCells) return false;
  for (Real x = low[0]; x <= high[0]; ++x) {
    for (Real y = low[1]; y <= high[1]; ++y) {
      for (Real z = low[2]; z <= high[2]; ++z) entries.push_back({{x, y, z}, index});
    }
  }
  return true;
}

}  // namespace

std::vector<IndexPair> gridPairs(std::span<const Aabb<3>> boxes, Real cell) {
  requirePositive(cell, "cell");
  for (const Aabb<3>& box : boxes) requireBox(box);

  const auto count = static_cast<std::int32_t>(boxes.size());
  std::vector<Entry> entries;
  std::vector<std::int32_t> big;
  for (std::int32_t i = 0; i < count; ++i) {
    if (!enter(i, boxes[i], cell, entries)) big.push_back(i);
  }
  std::sort(entries.begin(), entries.end());

  std::vector<IndexPair> pairs;
  for (auto a = entries.begin(); a != entries.end(); ++a) {
    // The others in this cell stand behind it.
    for (auto b = a + 1; b != entries.end() && b->cell == a->cell; ++b) {
      if (!meets(boxes[a->box], boxes[b->box])) continue;
      // In how many cells they ever meet, this corner is in one.
      const Vector3 corner = boxes[a->box].low.cwiseMax(boxes[b->box].low);
      if (cellOf(corner, cell) == a->cell) pairs.push_back({a->box, b->box});
    }
  }
  for (const std::int32_t a : big) {
    for (std::int32_t b = 0; b < count; ++b) {
      const bool done = std::binary_search(big.begin(), big.end(), b) && b <= a;
      if (!done && meets(boxes[a], boxes[b])) pairs.push_back(pairOf(a, b));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace carom
