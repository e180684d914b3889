#include "carom/broadphase/broad_phase.hpp"

#include <algorithm>
#include <cmath>

#include "carom/broadphase/require_box.hpp"
#include "carom/core/checks.hpp"
#include "carom/core/reserve_ahead.hpp"

namespace carom {
namespace {

bool isBox(const Aabb<3>& box) {
  return (box.low.array() <= box.high.array()).all();
}

void requireBody(const BroadPhase& phase, std::int32_t body) {
  if (!phase.contains(body)) reject("body", std::to_string(body), "must be in the broad phase");
}

}  // namespace

BroadPhase::BroadPhase(const BroadPhaseSettings& settings) : settings_(settings) {
  requireNonNegative(settings.margin, "margin");
  requireNonNegative(settings.stepsAhead, "stepsAhead");
  if (!(settings.rebuildAt >= 1)) reject("rebuildAt", toText(settings.rebuildAt), "must be >= 1");
}

void BroadPhase::reserve(std::int32_t bodies, std::int32_t pairs) {
  if (bodies <= 0) return;
  bodies_.reserve(bodies);
  moving_.reserve(bodies);
  lively_.reserve(bodies);
  livelyBodies_.reserve(bodies);
  immovable_.reserve(bodies);
  pairs_.reserve(bodies, pairs);
  moved_.reserve(bodies);
  items_.reserve(bodies);
  boxes_.reserve(bodies);
  begun_.reserve(pairs);
  ended_.reserve(pairs);
  removed_.reserve(pairs);
}

void BroadPhase::list(std::int32_t body) {
  if (bodies_[body].isListed) return;
  bodies_[body].isListed = true;
  moved_.push_back(body);
}

Aabb<3> BroadPhase::withRoom(const Aabb<3>& box, const Vector3& way) const {
  // Infinite edges have room enough, and say nothing of the size of a body.
  Real sum = 0;
  int finite = 0;
  for (int k = 0; k < 3; ++k) {
    const Real edge = box.high(k) - box.low(k);
    if (!std::isfinite(edge)) continue;
    sum += edge;
    ++finite;
  }
  Real width = finite > 0 ? settings_.margin * sum / finite : 0;
  // What goes farther in a step than its room reaches leaves it in the next one anyway.
  if (settings_.stepsAhead < 1 && way.squaredNorm() > width * width) width = 0;
  const Vector3 room = Vector3::Constant(width);
  const Vector3 ahead = settings_.stepsAhead * way;
  return {box.low - room + ahead.cwiseMin(0), box.high + room + ahead.cwiseMax(0)};
}

// Has a body that was fast far more room than it will need? Infinite edges say no.
bool BroadPhase::hasTooMuch(const Aabb<3>& room, const Aabb<3>& box, const Vector3& way) const {
  const Vector3 edges = box.high - box.low, left = room.high - room.low - edges;
  const Real enough = 4 * settings_.margin * edges.sum();
  for (int k = 0; k < 3; ++k) {
    if (left(k) > enough + 3 * settings_.stepsAhead * std::abs(way(k))) return true;
  }
  return false;
}

void BroadPhase::add(std::int32_t body, const Aabb<3>& box, Mobility mobility,
                     std::uint32_t family) {
  requireItem(body);
  requireBox(box);
  if (contains(body)) reject("body", std::to_string(body), "must not be in the broad phase yet");
  if (static_cast<std::size_t>(body) >= bodies_.size()) {
    bodies_.resize(body + 1);
    moved_.reserve(bodies_.capacity());
  }
  Body& added = bodies_[body];
  added.isIn = added.isNew = true;
  added.isImmovable = mobility == Mobility::immovable;
  added.box = added.isImmovable ? box : withRoom(box, Vector3::Zero());
  added.family = family;
  ++size_;
  if (!added.isImmovable) {
    if (movingSize_ == 0) family_ = family;
    ++movingSize_;
    familySize_ += family == family_ ? 1 : 0;
  }
  list(body);
}

void BroadPhase::remove(std::int32_t body) {
  requireBody(*this, body);
  pairs_.forEachOf(body, [&](std::int32_t slot, std::int32_t other) {
    removed_.push_back({pairOf(body, other), slot});
    pairs_.remove(slot);
  });
  if (!bodies_[body].isNew) treeOf(bodies_[body]).remove(body);
  if (bodies_[body].livelyAt != kNone) noLongerLively(body);
  if (!bodies_[body].isImmovable) {
    --movingSize_;
    familySize_ -= bodies_[body].family == family_ ? 1 : 0;
  }
  // It may stand in moved_ still, and is passed over there.
  bodies_[body] = Body();
  --size_;
}

bool BroadPhase::staysIn(std::int32_t body, const Aabb<3>& box, const Vector3& way) const {
  if (!contains(body)) return false;
  const Body& one = bodies_[body];
  return !one.isImmovable && holds(one.box, box) && isBox(box) && !hasTooMuch(one.box, box, way);
}

void BroadPhase::move(std::int32_t body, const Aabb<3>& box, const Vector3& way) {
  requireBody(*this, body);
  if (staysIn(body, box, way)) return;
  requireBox(box);
  requireFinite(way, "way");
  Body& moved = bodies_[body];
  moved.box = moved.isImmovable ? box : withRoom(box, way);
  list(body);
}

void BroadPhase::touch(std::int32_t body) {
  requireBody(*this, body);
  list(body);
}

// Fewer than this share of all: each asks the trees. The numbers here are those for which both ways
// are about as fast in the suite `broadphase`.
constexpr std::int64_t kShare = 6;
constexpr std::int32_t kSweepUpTo = 500;  // bodies; above, a grid compares fewer
constexpr std::int64_t kMostBig = 16;     // bodies that each would be compared with all
constexpr std::size_t kMostScanned = 16;  // bodies that are compared with all
constexpr std::int32_t kScans = 2;        // updates after one that searched through all
constexpr std::int32_t kGridRest = 64;    // updates, where it had too many big ones
constexpr std::int64_t kFewOf = 16;       // fewer than this share become lively
constexpr std::int64_t kCalmAfter = 64;   // updates by trees within its box

// Whether no two bodies that may move can be a pair.
bool BroadPhase::areStrangers() const {
  return settings_.search == PairSearch::chosen && family_ != 0 && familySize_ == movingSize_;
}

// Whether the tree of moving bodies will be asked: among strangers by immovable ones only.
bool BroadPhase::asksMoving(bool strangers) const {
  return !strangers || std::any_of(moved_.begin(), moved_.end(), [&](std::int32_t body) {
    return bodies_[body].isListed && bodies_[body].isImmovable;
  });
}

PairSearch BroadPhase::chooseSearch() {
  PairSearch search = settings_.search;
  if (search == PairSearch::chosen) {
    if (kShare * static_cast<std::int64_t>(moved_.size()) < size_) return PairSearch::trees;
    search = size_ <= kSweepUpTo ? PairSearch::sweep : PairSearch::grid;
    if (search == PairSearch::grid && gridRests_ > 0) {
      --gridRests_;
      return PairSearch::trees;
    }
  }
  if (search == PairSearch::trees) return search;
  scansLeft_ = kScans;
  gatherAll();
  if (search == PairSearch::sweep) {
    sweep_.update(boxes_);
    return search;
  }
  grid_.update(boxes_);
  if (settings_.search == PairSearch::chosen && grid_.bigBoxes() > kMostBig) {
    gridRests_ = kGridRest;
    return PairSearch::trees;
  }
  return search;
}

// Few bodies, right after all were searched through without a tree: comparing them with all costs
// less than to bring the tree up to date, which the next update may not need.
bool BroadPhase::mayScan() {
  if (settings_.search != PairSearch::chosen || !isStale_ || scansLeft_ == 0) return false;
  if (moved_.size() > kMostScanned) return false;
  --scansLeft_;
  ++counters_.byScan;
  gatherAll();
  return true;
}

// All bodies and their boxes, without gaps.
void BroadPhase::gatherAll() {
  items_.clear();
  boxes_.clear();
  for (std::size_t body = 0; body < bodies_.size(); ++body) {
    if (!bodies_[body].isIn) continue;
    items_.push_back(static_cast<std::int32_t>(body));
    boxes_.push_back(bodies_[body].box);
  }
}

Tree<3>& BroadPhase::treeOf(const Body& body) {
  if (body.isImmovable) return immovable_;
  return body.livelyAt == kNone ? moving_ : lively_;
}

// Gives the trees of bodies that may move the boxes that they have missed.
void BroadPhase::refreshTrees() const {
  isStale_ = false;
  for (Tree<3>* tree : {&moving_, &lively_}) {
    items_.clear();
    boxes_.clear();
    tree->forEach([&](std::int32_t body) {
      items_.push_back(body);
      boxes_.push_back(bodies_[body].box);
    });
    tree->move(items_, boxes_);
  }
}

void BroadPhase::updateTrees(bool movesToo) {
  if (movesToo) {
    if (isStale_) refreshTrees();
    ++counters_.byTrees;
    moveInTrees();
  }
  for (const std::int32_t body : moved_) {
    Body& moved = bodies_[body];
    if (!moved.isListed) continue;
    ++counters_.left;
    if (moved.isNew) {
      moved.isNew = false;
      treeOf(moved).insert(body, moved.box);
    } else if (moved.isImmovable) {
      immovable_.move(body, moved.box);
    }
  }
  if (!movesToo) {
    isStale_ = true;
    return;
  }
  if (2 * static_cast<std::size_t>(movingSize_) >= bodies_.size()) {
    // Either tree may come to hold them all, in a step that should take no memory.
    const auto all = static_cast<std::int32_t>(bodies_.size());
    for (Tree<3>* tree : {&moving_, &lively_}) tree->reserve(all);
    reserveAhead(livelyBodies_, bodies_.size());
  }
  calmDown();
  for (Tree<3>* tree : {&moving_, &lively_, &immovable_}) {
    if (2 * tree->unsettled() <= tree->size() && tree->worsening() <= settings_.rebuildAt) continue;
    tree->rebuild();
    ++counters_.rebuilt;
  }
  // Neighbours one after the other find the same nodes still in the cache.
  if (kShare * static_cast<std::int64_t>(moved_.size()) >= size_) orderMoved();
}

// Those that left their boxes: many of a tree are moved in it together, few become lively.
void BroadPhase::moveInTrees() {
  for (const bool lively : {true, false}) {
    items_.clear();
    boxes_.clear();
    for (const std::int32_t body : moved_) {
      const Body& moved = bodies_[body];
      if (!moved.isListed || moved.isNew || moved.isImmovable) continue;
      if ((moved.livelyAt != kNone) != lively) continue;
      items_.push_back(body);
      boxes_.push_back(moved.box);
      if (lively) livelyBodies_[moved.livelyAt].leftAt = counters_.byTrees;
    }
    const bool few = kFewOf * static_cast<std::int64_t>(items_.size()) <= moving_.size();
    if (lively || !few) {
      (lively ? lively_ : moving_).move(items_, boxes_);
    } else {
      for (const std::int32_t body : items_) becomeLively(body);
    }
  }
}

void BroadPhase::becomeLively(std::int32_t body) {
  Body& one = bodies_[body];
  moving_.remove(body);
  lively_.insert(body, one.box);
  one.livelyAt = static_cast<std::int32_t>(livelyBodies_.size());
  livelyBodies_.push_back({body, counters_.byTrees});
}

// Takes a body out of the list of lively ones: the last one takes its place.
void BroadPhase::noLongerLively(std::int32_t body) {
  const std::int32_t place = bodies_[body].livelyAt;
  bodies_[livelyBodies_.back().body].livelyAt = place;
  livelyBodies_[place] = livelyBodies_.back();
  livelyBodies_.pop_back();
  bodies_[body].livelyAt = kNone;
}

// Looks at some of the lively bodies, in turn: who has not left its box for long goes back.
void BroadPhase::calmDown() {
  for (std::size_t left = 2 + livelyBodies_.size() / kCalmAfter; left > 0; --left) {
    if (livelyBodies_.empty()) return;
    if (calmNext_ >= livelyBodies_.size()) calmNext_ = 0;
    const Lively& one = livelyBodies_[calmNext_];
    if (counters_.byTrees - one.leftAt <= kCalmAfter) {
      ++calmNext_;
      continue;
    }
    const std::int32_t body = one.body;
    lively_.remove(body);
    noLongerLively(body);
    moving_.insert(body, bodies_[body].box);
  }
}

void BroadPhase::orderMoved() {
  const auto end = std::remove_if(moved_.begin(), moved_.end(),
                                  [&](std::int32_t body) { return !bodies_[body].isImmovable; });
  moved_.erase(end, moved_.end());
  for (const Tree<3>* tree : {&moving_, &lively_}) {
    tree->forEach([&](std::int32_t body) {
      if (bodies_[body].isListed) moved_.push_back(body);
    });
  }
}

void BroadPhase::sortEvents() {
  // Room to end all pairs in a later update, or to begin as many.
  const auto pairs = static_cast<std::size_t>(pairs_.slots());
  for (std::vector<Event>* list : {&begun_, &ended_, &removed_}) reserveAhead(*list, pairs);
  for (Part& part : parts_) part.events.reserve(begun_.capacity());
  std::sort(begun_.begin(), begun_.end());
  std::sort(ended_.begin(), ended_.end());
  counters_.begun += static_cast<std::int64_t>(begun_.size());
  counters_.ended += static_cast<std::int64_t>(ended_.size());
}

}  // namespace carom
