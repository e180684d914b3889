#pragma once
// How does a sweep profit from the step before?
//
// Method: bodies move little from step to step, so that their order along an axis hardly changes.
// The order is kept, and put right by letting each box move past those that it has overtaken
// (insertion sort): as many exchanges as bodies that passed each other. The axis is the one on
// which the centres are spread most; it changes only when another one is twice as good, since a new
// axis means a new sort. Boxes are copied into the order, so that the sweep reads memory forwards.
// Source: Baraff 1992; Cohen and others 1995; Tracy, Buss and Woods, Efficient large-scale
// sweep and prune methods, 2009.
// Not handled: boxes that come and go (the order is made anew when their number changes).

#include <cstdint>
#include <span>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "carom/detection/aabb.hpp"

namespace carom {

/// A sweep along the best axis that stays sorted. The fast twin of sweepAndPrune(). Takes memory
/// only to grow. \ingroup broadphase
class SortedSweep {
 public:
  /// Puts the boxes in order. \param boxes those of this step, low not above high, no NaN [m]
  void update(std::span<const Aabb<3>> boxes);

  /// All pairs of closed boxes of the last update() that meet.
  /// \param visit called with two indices, the smaller first, each pair once
  /// \return how many pairs were compared
  template <class Visit>
  std::int64_t pairs(Visit&& visit) const {
    std::int64_t tested = 0;
    const std::size_t count = sorted_.size();
    for (std::size_t a = 0; a < count; ++a) {
      const Real end = sorted_[a].box.high(axis_);
      for (std::size_t b = a + 1; b < count && sorted_[b].box.low(axis_) <= end; ++b) {
        ++tested;
        if (!meets(sorted_[a].box, sorted_[b].box)) continue;
        const IndexPair pair = pairOf(sorted_[a].index, sorted_[b].index);
        visit(pair.first, pair.second);
      }
    }
    return tested;
  }

  /// The axis of the sweep. \return 0, 1 or 2
  int axis() const {
    return axis_;
  }

  /// Exchanges that all updates took. \return 0 or more
  std::int64_t exchanges() const {
    return exchanges_;
  }

  /// How often the order was made anew. \return 0 or more
  std::int64_t sorts() const {
    return sorts_;
  }

 private:
  struct Placed {
    Aabb<3> box;
    std::int32_t index = 0;
  };
  int bestAxis() const;
  void sortAnew();

  std::vector<Placed> sorted_;
  int axis_ = 0;
  std::int64_t exchanges_ = 0;
  std::int64_t sorts_ = 0;
};

}  // namespace carom
