#pragma once
// Which pairs of bodies have come near each other since the last step, and which have parted?
//
// Method: every body gets a box with room to move. As long as its tight box stays inside, there is
// nothing to do for it. One that leaves gets a new box and asks the trees who meets it; its old
// pairs are looked at again, its new ones are added. Bodies that never move are in a tree of their
// own, which is asked by those who move and never asks itself.
// How those that left find partners (PairSearch): if they are fewer than a sixth of all, each asks
// the trees. If more, the pairs of all are found anew, which costs less for each: by a sweep up to
// 500 bodies, by a grid above, unless more than 16 bodies are too big for its cells. The trees then
// wait until they are asked for; a few bodies that leave their boxes right after that are compared
// with all. The same pairs come out, whichever way.
// Those that left their boxes lately, by ones and twos, are in a tree of their own, and go back to
// the large one when they have been still for a while: ten that move beside a crowd that rests
// change a tree of ten.
// Why only those that left: in a pile at rest nobody does, and the update costs nothing.
// Source: the moved list and the fat boxes of Box2D (Catto, 2009; GDC 2019); two trees, for those
// that moved lately and those that did not: btDbvtBroadphase of Bullet (Presson, 2008).
// Not handled: whether the shapes touch (detection), which pairs should not (the caller's `accept`).

#include <cstdint>
#include <span>
#include <vector>

#include "carom/broadphase/grid_pairs.hpp"
#include "carom/broadphase/index_pair.hpp"
#include "carom/broadphase/pair_cache.hpp"
#include "carom/broadphase/pair_grid.hpp"
#include "carom/broadphase/sorted_sweep.hpp"
#include "carom/broadphase/sweep_and_prune.hpp"
#include "carom/broadphase/tree.hpp"
#include "carom/core/kept_threads.hpp"
#include "carom/core/variant.hpp"

namespace carom {

/// May a body move? \ingroup broadphase
enum class Mobility {
  moving,    ///< it may: meets all others
  immovable  ///< it rests for good: meets moving ones only
};

/// How bodies that left their boxes find partners. \ingroup broadphase
enum class PairSearch {
  chosen,  ///< in each update by the rule above
  trees,   ///< each asks the trees
  sweep,   ///< all together, along the best axis
  grid     ///< all together, in a grid
};

/// How a broad phase works. \ingroup broadphase
struct BroadPhaseSettings {
  /// Room on each side of a moving body, over the mean edge of its box [1]. More room means fewer
  /// updates and more pairs that do not meet. None for what goes farther than that in a step, unless
  /// the room reaches a step ahead.
  Real margin = 0.1;
  /// How many steps' way the room reaches ahead [1].
  Real stepsAhead = 8;
  /// The tree is made anew when its surface has grown by this factor [1].
  Real rebuildAt = 2;
  /// How partners are found.
  PairSearch search = PairSearch::chosen;
};

/// What the updates have done so far. \ingroup broadphase
struct BroadPhaseCounters {
  std::int64_t updates = 0;  ///< calls of update()
  std::int64_t left = 0;     ///< bodies that had left their boxes
  std::int64_t visited = 0;  ///< nodes of trees looked at
  std::int64_t tested = 0;   ///< pairs of bodies whose boxes were compared
  std::int64_t begun = 0;    ///< pairs that came near
  std::int64_t ended = 0;    ///< pairs that parted
  std::int64_t byTrees = 0;  ///< updates in which bodies asked the trees
  std::int64_t bySweep = 0;  ///< updates that swept through all
  std::int64_t byGrid = 0;   ///< updates that put all into a grid
  std::int64_t byScan = 0;   ///< updates in which few bodies were compared with all
  std::int64_t rebuilt = 0;  ///< trees made anew
};

/// Bodies' boxes and the pairs that are near each other. A body is a number from 0 that the caller
/// chose. The same calls give the same pairs in the same order.
/// \ingroup broadphase
class BroadPhase {
 public:
  /// An empty broad phase. \param settings how it works
  /// \throws InvalidInput if a margin is negative or not finite, or the factor is below 1
  explicit BroadPhase(const BroadPhaseSettings& settings = {});

  /// Makes room, so that no call takes memory up to this size.
  /// \param bodies the first number that no body has \param pairs how many pairs at a time
  void reserve(std::int32_t bodies, std::int32_t pairs);

  /// Puts a body in; its pairs begin with the next update().
  /// \param body a number from 0 that is not in
  /// \param box its tight box [m, world]; infinite sides allowed
  /// \param mobility whether it may move
  /// \param family zero, or a number: two bodies of one family are never a pair. As long as all that
  ///   move are of one family nobody looks for those at all
  /// \throws InvalidInput if it is in already or the box holds no point; then nothing is changed
  void add(std::int32_t body, const Aabb<3>& box, Mobility mobility, std::uint32_t family = 0);

  /// Takes a body out; its pairs end at once and are in ended() after the next update().
  /// \param body that is in \throws InvalidInput if it is not
  void remove(std::int32_t body);

  /// Says where a body is now. Costs a comparison as long as it has room, and not far too much.
  /// \param body that is in \param box its tight box [m, world]
  /// \param way its displacement in a step like this one [m]; the room reaches ahead along it
  /// \throws InvalidInput if it is not in, the box holds no point or the way is not finite
  void move(std::int32_t body, const Aabb<3>& box, const Vector3& way = Vector3::Zero());

  /// Whether move() would do nothing; from several threads at once. \param body any number
  /// \param box its tight box [m, world] \param way as for move() [m] \return true if it would not
  bool staysIn(std::int32_t body, const Aabb<3>& box, const Vector3& way = Vector3::Zero()) const;

  /// Lets a body's pairs be looked at again by the next update(), as when its filter has changed.
  /// \param body that is in \throws InvalidInput if it is not
  void touch(std::int32_t body);

  /// Finds who has come near whom, and who has parted.
  /// \param accept called with two bodies (the smaller number first) whose boxes meet and that are
  ///   no pair yet, and with those of pairs that are looked at again: true if they may be a pair
  /// \param threads that share the search, or none: then `accept` is called by all of them; the
  ///   result is the same for any number
  template <class Accept>
  void update(Accept&& accept, KeptThreads* threads = nullptr);

  /// As above, with every pair accepted.
  void update() {
    update([](std::int32_t, std::int32_t) { return true; });
  }

  /// A pair and its slot in pairs(). Ordered by the pair.
  struct Event {
    IndexPair pair;             ///< the two bodies
    std::int32_t slot = kNone;  ///< where it is, or was
    /// Compares pairs, then slots. \param self one event \param other another \return their order
    friend constexpr auto operator<=>(const Event& self, const Event& other) = default;
  };

  /// The pairs that the last update() found. \return sorted by bodies
  std::span<const Event> begun() const {
    return begun_;
  }

  /// The pairs that ended in the last update() or were taken out before it. Their slots may already
  /// be those of begun() pairs: treat these first.
  /// \return sorted by bodies
  std::span<const Event> ended() const {
    return ended_;
  }

  /// All pairs that are near each other. \return by slots
  const PairCache& pairs() const {
    return pairs_;
  }

  /// Is a body in? \param body any number \return true if it is
  bool contains(std::int32_t body) const {
    return body >= 0 && static_cast<std::size_t>(body) < bodies_.size() && bodies_[body].isIn;
  }

  /// The box of a body with its room. \param body that is in \return [m, world]
  const Aabb<3>& box(std::int32_t body) const {
    return bodies_[body].box;
  }

  /// The bodies that may move and whose boxes meet one, as of the last update(). Not to be called by
  /// two threads at once: it may have to bring the trees up to date.
  /// \param box low not above high [m, world] \param visit called with each body, once
  template <class Visit>
  void overlapMoving(const Aabb<3>& box, Visit&& visit) const {
    if (isStale_) refreshTrees();
    moving_.overlap(box, visit);
    lively_.overlap(box, visit);
  }

  /// The bodies that never move. \return as above
  const Tree<3>& immovableTree() const {
    return immovable_;
  }

  /// What the updates have done so far. \return counts
  const BroadPhaseCounters& counters() const {
    return counters_;
  }

 private:
  struct Body {
    Aabb<3> box;  // with room; of an immovable one tight
    bool isIn = false;
    bool isImmovable = false;
    bool isListed = false;  // in moved_
    bool isNew = false;     // no tree knows it yet
    std::uint32_t family = 0;
    std::int32_t livelyAt = kNone;  // its place in livelyBodies_, if lively_ has it
  };
  struct Lively {
    std::int32_t body = kNone;
    std::int64_t leftAt = 0;  // the last update by trees in which it had left its box
  };
  void list(std::int32_t body);
  bool hasTooMuch(const Aabb<3>& room, const Aabb<3>& box, const Vector3& way) const;
  Aabb<3> withRoom(const Aabb<3>& box, const Vector3& way) const;
  PairSearch chooseSearch();
  bool areStrangers() const;
  bool asksMoving(bool strangers) const;
  bool mayScan();
  void updateTrees(bool movesToo);
  void moveInTrees();
  void becomeLively(std::int32_t body);
  void noLongerLively(std::int32_t body);
  void calmDown();
  void orderMoved();
  void refreshTrees() const;
  Tree<3>& treeOf(const Body& body);
  void gatherAll();
  void sortEvents();
  // What one thread has found. Each has lines of the cache of its own.
  struct alignas(64) Part {
    std::vector<Event> events;  // old pairs, or new ones without a slot
    std::int64_t tested = 0, visited = 0;
  };
  template <class Accept>
  void findEnded(std::int32_t body, Accept&& accept, Part& part) const;
  template <class Found>
  void scanFor(Part& part, std::int32_t body, Found&& found) const;
  template <class Found>
  void askTrees(Part& part, std::int32_t body, bool strangers, Found&& found) const;
  template <class Work>
  void inParts(KeptThreads* threads, std::size_t count, Work&& work);
  template <class Take>
  void takeParts(Take&& take);
  template <class Found>
  void searchNew(PairSearch how, bool scans, bool strangers, KeptThreads* threads, Found&& found);
  template <class Found>
  void searchAll(PairSearch search, KeptThreads* threads, Found&& found);

  BroadPhaseSettings settings_;
  BroadPhaseCounters counters_;
  std::vector<Body> bodies_;
  mutable Tree<3> moving_;        // that may move, without those of the next
  mutable Tree<3> lively_;        // of these: that left their boxes lately
  mutable bool isStale_ = false;  // the two do not know the boxes of all yet
  Tree<3> immovable_;
  SortedSweep sweep_;
  PairGrid grid_;
  PairCache pairs_;
  std::int32_t size_ = 0;            // bodies that are in
  std::int32_t movingSize_ = 0;      // of these: that may move
  std::uint32_t family_ = 0;         // of the first body that may move
  std::int32_t familySize_ = 0;      // how many that may move are of it
  std::int32_t gridRests_ = 0;       // updates until a grid is tried again
  std::int32_t scansLeft_ = 0;       // updates that may still do without a tree
  std::vector<std::int32_t> moved_;  // bodies that left their boxes, are new, or were touched
  std::vector<Lively> livelyBodies_;
  std::size_t calmNext_ = 0;                 // the one of them to look at next
  mutable std::vector<std::int32_t> items_;  // some bodies, and their boxes
  mutable std::vector<Aabb<3>> boxes_;
  std::vector<Event> begun_, ended_, removed_;
  std::vector<Part> parts_;  // of the loop at hand
};

template <class Accept>
void BroadPhase::update(Accept&& accept, KeptThreads* threads) {
  ++counters_.updates;
  begun_.clear();
  ended_.swap(removed_);
  removed_.clear();
  if (moved_.empty()) return sortEvents();
  const bool strangers = areStrangers();
  const PairSearch search = strangers ? PairSearch::trees : chooseSearch();
  const bool scans = search == PairSearch::trees && !strangers && mayScan();
  updateTrees(search == PairSearch::trees && !scans && asksMoving(strangers));

  inParts(threads, moved_.size(), [&](Part& part, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) findEnded(moved_[i], accept, part);
  });
  takeParts([&](const Event& event) {
    ended_.push_back(event);
    pairs_.remove(event.slot);
  });

  // New pairs: those that meet and are no pair yet.
  searchNew(search, scans, strangers, threads, [&](Part& part, std::int32_t a, std::int32_t b) {
    const std::uint32_t family = bodies_[a].family;
    if (family != 0 && family == bodies_[b].family) return;
    if (pairs_.find(a, b) != kNone) return;
    const IndexPair pair = pairOf(a, b);
    if (accept(pair.first, pair.second)) part.events.push_back({pair, kNone});
  });
  takeParts([&](const Event& event) {
    begun_.push_back({event.pair, pairs_.add(event.pair.first, event.pair.second)});
  });
  for (const std::int32_t body : moved_) bodies_[body].isListed = false;
  moved_.clear();
  sortEvents();
}

// Old pairs of a body that do not meet any longer.
template <class Accept>
void BroadPhase::findEnded(std::int32_t body, Accept&& accept, Part& part) const {
  if (!bodies_[body].isListed) return;
  pairs_.forEachOf(body, [&](std::int32_t slot, std::int32_t other) {
    // Both moved: the smaller number looks at it.
    if (bodies_[other].isListed && other < body) return;
    ++part.tested;
    const IndexPair pair = pairOf(body, other);
    if (meets(bodies_[body].box, bodies_[other].box) && accept(pair.first, pair.second)) return;
    part.events.push_back({pair, slot});
  });
}

// Does a loop in as many parts as there are threads. What they find is taken in the order of the
// loop afterwards, so that pairs get the same slots for any number of threads.
template <class Work>
void BroadPhase::inParts(KeptThreads* threads, std::size_t count, Work&& work) {
  constexpr std::size_t kFew = 64;  // are not worth a second thread
  const bool shares = threads != nullptr && count > kFew;
  const std::size_t parts = shares ? static_cast<std::size_t>(threads->count()) : 1;
  if (parts_.size() < parts) parts_.resize(parts);
  auto run = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      work(parts_[k], count * k / parts, count * (k + 1) / parts);
    }
  };
  if (shares) {
    threads->loop(parts, 1, run);
  } else {
    run(0, 1);
  }
}

template <class Take>
void BroadPhase::takeParts(Take&& take) {
  for (Part& part : parts_) {
    for (const Event& event : part.events) take(event);
    part.events.clear();
    counters_.tested += part.tested;
    counters_.visited += part.visited;
    part.tested = part.visited = 0;
  }
}

template <class Found>
void BroadPhase::searchNew(PairSearch how, bool scans, bool strangers, KeptThreads* threads,
                           Found&& found) {
  if (how != PairSearch::trees) return searchAll(how, threads, found);
  const auto search = [&](Part& part, std::int32_t body) {
    if (scans) {
      scanFor(part, body, found);
    } else {
      askTrees(part, body, strangers, found);
    }
  };
  inParts(threads, moved_.size(), [&](Part& part, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (bodies_[moved_[i]].isListed) search(part, moved_[i]);
    }
  });
}

// Compares a body with all.
template <class Found>
void BroadPhase::scanFor(Part& part, std::int32_t body, Found&& found) const {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    ++part.tested;
    if (!meets(boxes_[i], bodies_[body].box) || items_[i] == body) continue;
    if (bodies_[items_[i]].isListed && items_[i] < body) continue;
    if (bodies_[items_[i]].isImmovable && bodies_[body].isImmovable) continue;
    found(part, body, items_[i]);
  }
}

template <class Found>
void BroadPhase::askTrees(Part& part, std::int32_t body, bool strangers, Found&& found) const {
  const auto met = [&](std::int32_t other) {
    ++part.tested;
    // Both moved: the smaller number finds the other one.
    if (other == body || (bodies_[other].isListed && other < body)) return;
    found(part, body, other);
  };
  if (!strangers || bodies_[body].isImmovable) {
    part.visited += moving_.overlap(bodies_[body].box, met);
    part.visited += lively_.overlap(bodies_[body].box, met);
  }
  if (!bodies_[body].isImmovable) part.visited += immovable_.overlap(bodies_[body].box, met);
}

template <class Found>
void BroadPhase::searchAll(PairSearch search, KeptThreads* threads, Found&& found) {
  const auto met = [&](Part& part, std::int32_t a, std::int32_t b) {
    const Body &one = bodies_[items_[a]], &other = bodies_[items_[b]];
    if (!one.isListed && !other.isListed) return;
    if (one.isImmovable && other.isImmovable) return;
    found(part, items_[a], items_[b]);
  };
  if (parts_.empty()) parts_.resize(1);
  Part& first = parts_.front();
  const auto metFirst = [&](std::int32_t a, std::int32_t b) { met(first, a, b); };
  if (search == PairSearch::sweep) {
    ++counters_.bySweep;
    if (takesPlainPath()) {
      for (const IndexPair& pair : sweepAndPrune(boxes_)) metFirst(pair.first, pair.second);
    } else {
      counters_.tested += sweep_.pairs(metFirst);
    }
    return;
  }
  ++counters_.byGrid;
  if (takesPlainPath()) {
    for (const IndexPair& pair : gridPairs(boxes_, grid_.cell())) metFirst(pair.first, pair.second);
    return;
  }
  inParts(threads, grid_.places(), [&](Part& part, std::size_t begin, std::size_t end) {
    part.tested +=
        grid_.pairsAt(begin, end, [&](std::int32_t a, std::int32_t b) { met(part, a, b); });
  });
  Part& last = parts_.back();
  last.tested += grid_.pairsOfBig([&](std::int32_t a, std::int32_t b) { met(last, a, b); });
}

}  // namespace carom
