#include "carom/broadphase/pair_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace carom {
namespace {

constexpr std::int64_t kMostCells = 64;  // more make a box a big one
constexpr Real kLastCell = 0x1p52;       // beyond it, neighbours have one number

}  // namespace

// Only for coordinates of boxes that were entered, which are below kLastCell cells.
std::int64_t PairGrid::numberOf(Real coordinate) const {
  const Real place = coordinate * perCell_;
  const auto whole = static_cast<std::int64_t>(place);  // towards zero
  return whole - (place < static_cast<Real>(whole) ? 1 : 0);
}

void PairGrid::chooseCell() {
  edges_.clear();
  for (const Aabb<3>& box : boxes_) {
    const Real edge = (box.high - box.low).maxCoeff();
    if (std::isfinite(edge) && edge > 0) edges_.push_back(edge);
  }
  cell_ = perCell_ = 1;
  if (edges_.empty()) return;
  const auto middle = edges_.begin() + static_cast<std::ptrdiff_t>(edges_.size() / 2);
  std::nth_element(edges_.begin(), middle, edges_.end());
  cell_ = std::clamp(2 * *middle, Real(1e-300), Real(1e300));
  perCell_ = 1 / cell_;
}

PairGrid::Cells PairGrid::cellsOf(const Aabb<3>& box) const {
  Cells cells;
  std::int64_t count = 1;
  for (int k = 0; k < 3; ++k) {
    // Also where a side is infinite.
    if (!(box.low(k) * perCell_ >= -kLastCell) || !(box.high(k) * perCell_ <= kLastCell)) {
      return cells;
    }
    const std::int64_t low = numberOf(box.low(k)), high = numberOf(box.high(k));
    if (high - low >= kMostCells) return cells;
    cells.low[static_cast<std::size_t>(k)] = low;
    cells.high[static_cast<std::size_t>(k)] = high;
    count *= high - low + 1;
  }
  cells.areMany = count > kMostCells;
  return cells;
}

void PairGrid::chooseKeys() {
  constexpr std::int64_t kFar = std::numeric_limits<std::int64_t>::max();
  std::array<std::int64_t, 3> last = {-kFar, -kFar, -kFar};
  base_ = {kFar, kFar, kFar};
  for (const Cells& cells : cells_) {
    if (cells.areMany) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      base_[k] = std::min(base_[k], cells.low[k]);
      last[k] = std::max(last[k], cells.high[k]);
    }
  }
  std::array<int, 3> bits = {};
  for (std::size_t k = 0; k < 3; ++k) {
    bits[k] = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(last[k] - base_[k])));
  }
  if (bits[0] + bits[1] + bits[2] > 63) bits = {21, 21, 21};
  shifts_ = {0, bits[0], bits[0] + bits[1]};
  for (std::size_t k = 0; k < 3; ++k) masks_[k] = (std::uint64_t(1) << bits[k]) - 1;
}

void PairGrid::enter(std::int32_t index) {
  const auto& [low, high, areMany] = cells_[index];
  for (std::int64_t z = low[2]; z <= high[2]; ++z) {
    const std::uint64_t layer = digitsOf(z, 2);
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      const std::uint64_t row = layer | digitsOf(y, 1);
      for (std::int64_t x = low[0]; x <= high[0]; ++x) {
        entries_.push_back({row | digitsOf(x, 0), index});
      }
    }
  }
}

// By counting, as few bits at a time as eleven at most leave, from the lowest; what all keys share
// is passed over. Stable, so boxes stay in order within a cell.
void PairGrid::sort() {
  constexpr int kMostBits = 11;
  std::uint64_t differ = 0;
  for (const Entry& entry : entries_) differ |= entry.key ^ entries_.front().key;
  other_.resize(entries_.size());
  const int all = static_cast<int>(std::bit_width(differ));
  const int rounds = (all + kMostBits - 1) / kMostBits;
  const int bits = rounds > 0 ? (all + rounds - 1) / rounds : 0;
  const std::uint64_t digits = std::uint64_t(1) << bits;
  std::array<std::uint32_t, (1 << kMostBits) + 1> starts;
  for (int shift = 0; shift < all; shift += bits) {
    if ((differ >> shift & (digits - 1)) == 0) continue;
    std::fill_n(starts.begin(), digits + 1, 0);
    for (const Entry& entry : entries_) ++starts[(entry.key >> shift & (digits - 1)) + 1];
    for (std::uint64_t digit = 0; digit < digits; ++digit) starts[digit + 1] += starts[digit];
    for (const Entry& entry : entries_) {
      other_[starts[entry.key >> shift & (digits - 1)]++] = entry;
    }
    entries_.swap(other_);
  }
}

void PairGrid::update(std::span<const Aabb<3>> boxes) {
  boxes_ = boxes;
  chooseCell();
  entries_.clear();
  big_.clear();
  cells_.clear();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    cells_.push_back(cellsOf(boxes[i]));
    if (cells_.back().areMany) big_.push_back(static_cast<std::int32_t>(i));
  }
  if (big_.size() == boxes.size()) return;
  chooseKeys();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!cells_[i].areMany) enter(static_cast<std::int32_t>(i));
  }
  // Boxes that move are in some more cells or some less each time: room for that.
  if (4 * entries_.capacity() < 5 * entries_.size()) entries_.reserve(2 * entries_.size());
  other_.reserve(entries_.capacity());
  sort();
}

}  // namespace carom
