#include "carom/broadphase/pair_grid.hpp"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr std::int64_t kMostCells = 64;  // more make a box a big one
constexpr Real kLastCell = 0x1p52;       // beyond it, neighbours have one number

}  // namespace

// Only for coordinates of boxes that were entered, which are below kLastCell cells.
std::int64_t PairGrid::numberOf(Real coordinate) const {
  return static_cast<std::int64_t>(std::floor(coordinate / cell_));
}

std::uint64_t PairGrid::keyOf(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::uint64_t kMask = (std::uint64_t(1) << 21) - 1;
  return (static_cast<std::uint64_t>(z) & kMask) << 42 |
         (static_cast<std::uint64_t>(y) & kMask) << 21 | (static_cast<std::uint64_t>(x) & kMask);
}

void PairGrid::chooseCell() {
  edges_.clear();
  for (const Aabb<3>& box : boxes_) {
    const Real edge = (box.high - box.low).maxCoeff();
    if (std::isfinite(edge) && edge > 0) edges_.push_back(edge);
  }
  cell_ = 1;
  if (edges_.empty()) return;
  const auto middle = edges_.begin() + static_cast<std::ptrdiff_t>(edges_.size() / 2);
  std::nth_element(edges_.begin(), middle, edges_.end());
  cell_ = std::clamp(1.5 * *middle, Real(1e-300), Real(1e300));
}

bool PairGrid::enter(std::int32_t index) {
  const Aabb<3>& box = boxes_[index];
  const Vector3 lowest = box.low / cell_, highest = box.high / cell_;
  if (!(lowest.minCoeff() >= -kLastCell) || !(highest.maxCoeff() <= kLastCell)) return false;
  std::array<std::int64_t, 3> low = {}, high = {};
  std::int64_t cells = 1;
  for (int k = 0; k < 3; ++k) {
    low[k] = numberOf(box.low(k));
    high[k] = numberOf(box.high(k));
    if (high[k] - low[k] >= kMostCells) return false;
    cells *= high[k] - low[k] + 1;
  }
  if (cells > kMostCells) return false;
  for (std::int64_t z = low[2]; z <= high[2]; ++z) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t x = low[0]; x <= high[0]; ++x) entries_.push_back({keyOf(x, y, z), index});
    }
  }
  return true;
}

// By counting eleven bits at a time, from the lowest; what all keys share is passed over. Stable,
// so boxes stay in order within a cell.
void PairGrid::sort() {
  constexpr int kBits = 11, kDigits = 1 << kBits;
  std::uint64_t differ = 0;
  for (const Entry& entry : entries_) differ |= entry.key ^ entries_.front().key;
  other_.resize(entries_.size());
  for (int shift = 0; shift < 64; shift += kBits) {
    if ((differ >> shift & (kDigits - 1)) == 0) continue;
    std::array<std::size_t, kDigits + 1> starts = {};
    for (const Entry& entry : entries_) ++starts[(entry.key >> shift & (kDigits - 1)) + 1];
    for (int digit = 0; digit < kDigits; ++digit) starts[digit + 1] += starts[digit];
    for (const Entry& entry : entries_) {
      other_[starts[entry.key >> shift & (kDigits - 1)]++] = entry;
    }
    entries_.swap(other_);
  }
}

void PairGrid::update(std::span<const Aabb<3>> boxes) {
  boxes_ = boxes;
  chooseCell();
  entries_.clear();
  big_.clear();
  isBig_.assign(boxes.size(), false);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto index = static_cast<std::int32_t>(i);
    if (enter(index)) continue;
    big_.push_back(index);
    isBig_[i] = true;
  }
  if (!entries_.empty()) sort();
}

}  // namespace carom
