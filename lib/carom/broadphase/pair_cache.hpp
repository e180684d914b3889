#pragma once
// Which pairs are near each other now, and since when?
//
// Method: every pair has a slot that it keeps as long as it lasts, so that others can keep by the
// same number what belongs to it (a manifold, the impulses of the last step). Each item heads a
// list of its own pairs: whether two items are a pair already is seen in the shorter list, and when
// an item has moved, only its own pairs are looked at.
// Why no hash table: an item has a handful of pairs, the list of the moved item has just been read,
// and no order of answers depends on addresses or hashes. Why not one sorted list: it would be
// rewritten in every step, also for pairs that rest.
// Source: the lists of contacts per body of Box2D (Catto, 2007).
// Not handled: which pairs there should be (broad_phase.hpp).

#include <array>
#include <vector>

#include "carom/broadphase/index_pair.hpp"

namespace carom {

/// Pairs of items, each in a slot of its own. \ingroup broadphase
class PairCache {
 public:
  /// Makes room, so that no call takes memory up to this size.
  /// \param items the first number that no item has \param pairs how many pairs at a time
  void reserve(std::int32_t items, std::int32_t pairs);

  /// The slot of a pair.
  /// \param a one item \param b another \return its slot, kNone if the two are no pair
  std::int32_t find(std::int32_t a, std::int32_t b) const;

  /// Makes two items a pair. Slots of ended pairs are used again, the latest first.
  /// \param a an item, a number from 0 \param b another one, not a pair with a yet
  /// \return its slot, until remove()
  std::int32_t add(std::int32_t a, std::int32_t b);

  /// Ends a pair. \param slot of a pair
  void remove(std::int32_t slot);

  /// The pair in a slot. \param slot of a pair \return its two items
  const IndexPair& pair(std::int32_t slot) const {
    return entries_[slot].pair;
  }

  /// How many pairs an item has. \param item any number from 0 \return 0 or more
  std::int32_t count(std::int32_t item) const {
    return known(item) ? heads_[item].count : 0;
  }

  /// How many pairs there are. \return 0 or more
  std::int32_t size() const {
    return size_;
  }

  /// How many slots there are, used or not: slots are below this. \return 0 or more
  std::int32_t slots() const {
    return static_cast<std::int32_t>(entries_.size());
  }

  /// The pairs of an item, the latest first. A pair may be removed while it is visited.
  /// \param item any number from 0 \param visit called with the slot and the other item
  template <class Visit>
  void forEachOf(std::int32_t item, Visit&& visit) const {
    if (!known(item)) return;
    for (Link link = heads_[item].first; link.slot != kNone;) {
      const Entry& entry = entries_[link.slot];
      const Link next = entry.next[link.side];
      visit(link.slot, link.side == 0 ? entry.pair.second : entry.pair.first);
      link = next;
    }
  }

  /// All pairs. \return sorted by their items
  std::vector<IndexPair> sorted() const;

 private:
  // A pair stands in two lists: as that of its first item (side 0) and of its second (side 1).
  struct Link {
    std::int32_t slot = kNone;
    std::int32_t side = 0;
  };
  struct Entry {
    IndexPair pair = {kNone, kNone};
    std::array<Link, 2> next, previous;
  };
  struct Head {
    Link first;
    std::int32_t count = 0;
  };
  bool known(std::int32_t item) const {
    return static_cast<std::size_t>(item) < heads_.size();
  }
  void link(std::int32_t item, Link link);
  void unlink(std::int32_t item, Link link);

  std::vector<Entry> entries_;
  std::vector<Head> heads_;         // by item
  std::vector<std::int32_t> free_;  // slots that can be used again
  std::int32_t size_ = 0;
};

}  // namespace carom
