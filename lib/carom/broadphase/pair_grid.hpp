#pragma once
// How is a grid made fast enough for every step?
//
// Method: that of gridPairs(), with memory that stays, an edge of the cells that follows the boxes
// (twice the middle one of their longest edges), and one number as the key of a
// cell, with as many bits for each axis as the scene has cells along it. Keys are sorted by counting
// (radix sort); cells that stand side by side along x stay so in memory.
// Why keys may repeat: in a scene of more than 2^63 cells, those 2^21 apart share one. Boxes that
// only share a key are told apart by comparing them, and a pair is reported where its corner's key
// is.
// Source: Ericson 2005, chapter 7; Green, Particle simulation using CUDA, 2008 (sorted keys).
// Not handled: boxes of very different sizes; big ones are compared with all.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// A grid that keeps its memory and chooses its edge. The fast twin of gridPairs(). Takes memory
/// only to grow. \ingroup broadphase
class PairGrid {
 public:
  /// Enters boxes; those of before are forgotten.
  /// \param boxes low not above high, no NaN [m]; must live until pairs() is done
  void update(std::span<const Aabb<3>> boxes);

  /// All pairs of closed boxes of the last update() that meet.
  /// \param visit called with two indices, the smaller first, each pair once
  /// \return how many pairs were compared
  template <class Visit>
  std::int64_t pairs(Visit&& visit) const;

  /// Places at which pairs of boxes that are not big are found. \return how many
  std::size_t places() const {
    return entries_.size();
  }

  /// Of the same pairs those that are found at some places; from several threads at once for
  /// different ones. \param begin the first place \param end behind the last one
  /// \param visit as for pairs() \return how many pairs were compared
  template <class Visit>
  std::int64_t pairsAt(std::size_t begin, std::size_t end, Visit&& visit) const;

  /// And those of big boxes. \param visit as for pairs() \return how many pairs were compared
  template <class Visit>
  std::int64_t pairsOfBig(Visit&& visit) const;

  /// Edge of the cells. \return [m]
  Real cell() const {
    return cell_;
  }

  /// How many boxes are compared with all. \return 0 or more
  std::int64_t bigBoxes() const {
    return static_cast<std::int64_t>(big_.size());
  }

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::int32_t box = 0;
  };
  // The cells that a box is in, first and last along each axis.
  struct Cells {
    std::array<std::int64_t, 3> low = {}, high = {};
    bool areMany = true;  // or without end
  };
  void chooseCell();
  void chooseKeys();
  void enter(std::int32_t index);
  void sort();
  Cells cellsOf(const Aabb<3>& box) const;
  std::int64_t numberOf(Real coordinate) const;
  std::uint64_t digitsOf(std::int64_t number, std::size_t axis) const;

  std::span<const Aabb<3>> boxes_;
  std::vector<Cells> cells_;  // of the boxes
  std::vector<Entry> entries_, other_;
  std::vector<std::int32_t> big_;  // rising
  std::vector<Real> edges_;
  std::array<std::int64_t, 3> base_ = {};    // the lowest cell of the scene
  std::array<std::uint64_t, 3> masks_ = {};  // of a number, before it is part of a key
  std::array<int, 3> shifts_ = {};           // where in a key the number along an axis begins
  Real cell_ = 1, perCell_ = 1;
};

inline std::uint64_t PairGrid::digitsOf(std::int64_t number, std::size_t axis) const {
  return (static_cast<std::uint64_t>(number - base_[axis]) & masks_[axis]) << shifts_[axis];
}

template <class Visit>
std::int64_t PairGrid::pairs(Visit&& visit) const {
  const std::int64_t tested = pairsAt(0, entries_.size(), visit);
  return tested + pairsOfBig(visit);
}

template <class Visit>
std::int64_t PairGrid::pairsAt(std::size_t begin, std::size_t end, Visit&& visit) const {
  std::int64_t tested = 0;
  for (std::size_t a = begin; a < end; ++a) {
    const Aabb<3>& box = boxes_[entries_[a].box];
    const Cells& cells = cells_[entries_[a].box];
    for (std::size_t b = a + 1; b < entries_.size() && entries_[b].key == entries_[a].key; ++b) {
      ++tested;
      const Aabb<3>& other = boxes_[entries_[b].box];
      if (!meets(box, other)) continue;
      // The cell of the lowest corner that both have.
      const Cells& otherCells = cells_[entries_[b].box];
      std::uint64_t key = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        key |= digitsOf(std::max(cells.low[k], otherCells.low[k]), k);
      }
      if (key != entries_[a].key) continue;
      const IndexPair pair = pairOf(entries_[a].box, entries_[b].box);
      visit(pair.first, pair.second);
    }
  }
  return tested;
}

template <class Visit>
std::int64_t PairGrid::pairsOfBig(Visit&& visit) const {
  std::int64_t tested = 0;
  const auto count = static_cast<std::int32_t>(boxes_.size());
  for (const std::int32_t a : big_) {
    for (std::int32_t b = 0; b < count; ++b) {
      if (cells_[b].areMany && b <= a) continue;
      ++tested;
      if (!meets(boxes_[a], boxes_[b])) continue;
      const IndexPair pair = pairOf(a, b);
      visit(pair.first, pair.second);
    }
  }
  return tested;
}

}  // namespace carom
