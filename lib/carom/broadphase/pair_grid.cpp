#include "carom/broadphase/pair_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

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

std::uint64_t PairGrid::keyOf(const std::array<std::int64_t, 3>& cell) const {
  std::uint64_t key = 0;
  for (int k = 2; k >= 0; --k) {
    const auto number = static_cast<std::uint64_t>(cell[k] - base_[k]);
    key = key << bits_[k] | (number & ((std::uint64_t(1) << bits_[k]) - 1));
  }
  return key;
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
  cell_ = std::clamp(1.5 * *middle, Real(1e-300), Real(1e300));
  perCell_ = 1 / cell_;
}

bool PairGrid::isBig(const Aabb<3>& box) const {
  std::int64_t cells = 1;
  for (int k = 0; k < 3; ++k) {
    // Also where a side is infinite.
    if (!(box.low(k) * perCell_ >= -kLastCell) || !(box.high(k) * perCell_ <= kLastCell)) {
      return true;
    }
    const std::int64_t along = numberOf(box.high(k)) - numberOf(box.low(k)) + 1;
    if (along > kMostCells) return true;
    cells *= along;
  }
  return cells > kMostCells;
}

void PairGrid::chooseKeys() {
  Aabb<3> all;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (!isBig_[i]) all = joined(all, boxes_[i]);
  }
  int bits = 0;
  for (int k = 0; k < 3; ++k) {
    base_[k] = numberOf(all.low(k));
    const auto cells = static_cast<std::uint64_t>(numberOf(all.high(k)) - base_[k]);
    bits_[k] = static_cast<int>(std::bit_width(cells));
    bits += bits_[k];
  }
  if (bits > 63) bits_ = {21, 21, 21};
}

void PairGrid::enter(std::int32_t index) {
  const Aabb<3>& box = boxes_[index];
  std::array<std::int64_t, 3> low, high, at;
  for (int k = 0; k < 3; ++k) {
    low[k] = numberOf(box.low(k));
    high[k] = numberOf(box.high(k));
  }
  for (at[2] = low[2]; at[2] <= high[2]; ++at[2]) {
    for (at[1] = low[1]; at[1] <= high[1]; ++at[1]) {
      for (at[0] = low[0]; at[0] <= high[0]; ++at[0]) entries_.push_back({keyOf(at), index});
    }
  }
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
  isBig_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    isBig_[i] = isBig(boxes[i]);
    if (isBig_[i]) big_.push_back(static_cast<std::int32_t>(i));
  }
  if (big_.size() == boxes.size()) return;
  chooseKeys();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!isBig_[i]) enter(static_cast<std::int32_t>(i));
  }
  // Boxes that move are in some more cells or some less each time: room for that.
  if (4 * entries_.capacity() < 5 * entries_.size()) entries_.reserve(2 * entries_.size());
  other_.reserve(entries_.capacity());
  sort();
}

}  // namespace carom
