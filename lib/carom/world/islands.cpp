#include "carom/world/islands.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/reserve_ahead.hpp"
#include "carom/core/variant.hpp"
#include "carom/world/find_islands.hpp"
#include "carom/world/may_sleep.hpp"
#include "carom/world/wake.hpp"

namespace carom::world {

namespace {

constexpr std::size_t kFewPairs = 256;  // are not worth a second thread

// Takes element `where` out of a list; the last one takes its place. Returns who moved, or kNone.
Index takeOut(std::vector<Index>& list, Index where) {
  const Index last = list.back();
  list.pop_back();
  if (static_cast<std::size_t>(where) == list.size()) return kNone;
  list[at(where)] = last;
  return last;
}

Index newIsland(WorldState& state) {
  Index island;
  if (state.freeIslands.empty()) {
    island = static_cast<Index>(state.islands.size());
    state.islands.reserve(state.bodies.capacity());  // there cannot be more
    state.islands.emplace_back();
    // Room to list each of them, and lists for them, so that an island that begins, ends or wakes
    // takes no memory.
    const std::size_t most = state.islands.capacity();
    state.freeIslands.reserve(most);
    state.awakeIslands.reserve(most);
    state.pile.islands.reserve(most);
    state.pile.firsts.reserve(most);
    state.pile.shares.reserve(most);
    state.islandLists.provide(2 * most);
  } else {
    island = state.freeIslands.back();
    state.freeIslands.pop_back();
  }
  IslandSlot& slot = state.islands[at(island)];
  slot.alive = slot.awake = true;
  slot.mustSplit = slot.unsorted = slot.still = false;
  slot.hardFor = slot.pileFor = 0;
  slot.isPile = false;
  slot.subStep = 0;
  slot.awakeAt = static_cast<Index>(state.awakeIslands.size());
  state.awakeIslands.push_back(island);
  ++state.islandCount;
  return island;
}

void unlistIsland(WorldState& state, Index island) {
  IslandSlot& slot = state.islands[at(island)];
  const Index moved = takeOut(state.awakeIslands, slot.awakeAt);
  if (moved != kNone) state.islands[at(moved)].awakeAt = slot.awakeAt;
  slot.awakeAt = kNone;
}

void endIsland(WorldState& state, Index island) {
  IslandSlot& slot = state.islands[at(island)];
  if (slot.awake) unlistIsland(state, island);
  state.islandLists.giveBack(slot.bodies);
  state.islandLists.giveBack(slot.pairs);
  slot.alive = false;
  state.freeIslands.push_back(island);
  --state.islandCount;
}

void addBody(WorldState& state, Index island, Index body) {
  state.islandLists.append(state.islands[at(island)].bodies, body);
  state.islands[at(island)].unsorted = true;
  state.islands[at(island)].still = false;
  state.bodies[at(body)].island = island;
}

void addPair(WorldState& state, Index island, Index pair) {
  PairSlot& slot = state.pairs[at(pair)];
  slot.island = island;
  slot.islandAt = static_cast<Index>(state.islands[at(island)].pairs.size());
  state.islandLists.append(state.islands[at(island)].pairs, pair);
  state.islands[at(island)].unsorted = true;
  state.islands[at(island)].still = false;
}

Index islandOf(WorldState& state, Index body) {
  if (state.bodies[at(body)].island == kNone) addBody(state, newIsland(state), body);
  return state.bodies[at(body)].island;
}

// Everything of one island goes over to the other.
void join(WorldState& state, Index from, Index to) {
  for (const Index body : state.islands[at(from)].bodies) addBody(state, to, body);
  for (const Index pair : state.islands[at(from)].pairs) addPair(state, to, pair);
  IslandSlot &joined = state.islands[at(to)], &ended = state.islands[at(from)];
  joined.mustSplit |= ended.mustSplit;
  joined.pileFor = std::max(joined.pileFor, ended.pileFor);
  joined.isPile |= ended.isPile;
  endIsland(state, from);
}

// Pairs in the order of their numbers. Few have come or gone, so that most stand in order: what
// breaks it is put aside together with what stood before it, sorted, and merged with the rest.
void sortPairs(WorldState& state, IslandSlot& island) {
  std::vector<OrderedPair>&kept = state.work.sorted, &aside = state.work.aside;
  reserveAhead(kept, island.pairs.size());
  kept.resize(island.pairs.size());
  shareOut(state, island.pairs.size(), kFewPairs, [&](std::size_t i) {
    fetchAhead(state, island.pairs, i);
    kept[i] = {state.pairs[at(island.pairs[i])].order, island.pairs[i]};
  });
  aside.clear();
  std::size_t count = 0;
  for (std::size_t i = 0; i < island.pairs.size(); ++i) {
    const OrderedPair next = kept[i];
    if (count == 0 || kept[count - 1].order < next.order) {
      kept[count++] = next;
      continue;
    }
    aside.push_back(kept[--count]);
    aside.push_back(next);
  }
  kept.resize(count);
  const auto before = [](const OrderedPair& a, const OrderedPair& b) { return a.order < b.order; };
  std::sort(aside.begin(), aside.end(), before);
  auto first = kept.begin(), second = aside.begin();
  for (std::size_t i = 0; i < island.pairs.size(); ++i) {
    const bool isFirst = second == aside.end() || (first != kept.end() && before(*first, *second));
    island.pairs[i] = isFirst ? (first++)->pair : (second++)->pair;
  }
  shareOut(state, island.pairs.size(), kFewPairs, [&](std::size_t i) {
    fetchAhead(state, island.pairs, i);
    Index& place = state.pairs[at(island.pairs[i])].islandAt;
    if (place != static_cast<Index>(i)) place = static_cast<Index>(i);
  });
}

void sortIsland(WorldState& state, IslandSlot& island) {
  std::sort(island.bodies.begin(), island.bodies.end());
  sortPairs(state, island);
  island.unsorted = false;
}

// The bodies of an island by local numbers, with their contacts. Immovable ones get numbers, too.
void describe(WorldState& state, const IslandSlot& island) {
  Workspace& work = state.work;
  work.flags.assign(island.bodies.size(), 1);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    state.bodies[at(island.bodies[i])].local = static_cast<Index>(i);
  }
  work.links.resize(island.pairs.size());
  shareOut(state, island.pairs.size(), kFewPairs, [&](std::size_t i) {
    fetchAhead(state, island.pairs, i);
    const PairSlot& slot = state.pairs[at(island.pairs[i])];
    const auto number = [&](Index index) {
      const BodySlot& body = state.bodies[at(index)];
      return isDynamic(body) ? body.local : kNone;
    };
    work.links[i] = {number(slot.bodyA), number(slot.bodyB)};
  });
  const auto newNumber = [&] {
    work.flags.push_back(0);
    return static_cast<Index>(work.flags.size()) - 1;
  };
  for (IndexPair& link : work.links) {
    if (link.first == kNone) link.first = newNumber();
    if (link.second == kNone) link.second = newNumber();
    link = pairOf(link.first, link.second);
  }
  work.labels.resize(work.flags.size());
}

void split(WorldState& state, Index index) {
  ++state.counters.islandsSplit;
  state.islands[at(index)].mustSplit = false;
  describe(state, state.islands[at(index)]);
  Workspace& work = state.work;
  findIslands(work.links, work.flags, work.labels);
  const std::size_t count = state.islands[at(index)].bodies.size();
  const auto isFirst = [&](Index label) { return label == work.labels[0]; };
  if (std::all_of(work.labels.begin(), work.labels.begin() + static_cast<std::ptrdiff_t>(count),
                  isFirst)) {
    if (!state.islands[at(index)].pairs.empty()) return;
  }
  // All leave; who still is held by a pair finds the others of its label again.
  work.set = state.islands[at(index)].bodies;
  work.setPairs = state.islands[at(index)].pairs;
  const int pileFor = state.islands[at(index)].pileFor;
  const bool isPile = state.islands[at(index)].isPile;
  endIsland(state, index);
  for (const Index body : work.set) state.bodies[at(body)].island = kNone;
  for (std::size_t i = 0; i < work.setPairs.size(); ++i) {
    PairSlot& pair = state.pairs[at(work.setPairs[i])];
    const Index body = isDynamic(state.bodies[at(pair.bodyA)]) ? pair.bodyA : pair.bodyB;
    const Index label = work.labels[at(state.bodies[at(body)].local)];
    const Index island = islandOf(state, work.set[at(label)]);
    state.islands[at(island)].pileFor = pileFor;
    state.islands[at(island)].isPile = isPile;
    addPair(state, island, work.setPairs[i]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Index body = work.set[i];
    const Index top = work.set[at(work.labels[i])];
    if (state.bodies[at(body)].island != kNone || top == body) continue;
    const Index island = state.bodies[at(top)].island;
    if (island != kNone) addBody(state, island, body);
  }
}

}  // namespace

std::uint64_t orderOf(const WorldState& state, const PairSlot& pair) {
  const auto joined = [](Index first, std::uint32_t second) {
    return static_cast<std::uint64_t>(first) << 32 | second;
  };
  // What cannot be moved comes before all that can, and after the shape that does.
  if (!isDynamic(state.bodies[at(pair.bodyA)])) {
    return joined(pair.shapeB, static_cast<std::uint32_t>(pair.shapeA));
  }
  constexpr std::uint32_t kMoves = 1u << 31;
  const IndexPair shapes = pairOf(pair.shapeA, pair.shapeB);
  return joined(shapes.first, kMoves | static_cast<std::uint32_t>(shapes.second));
}

void joinByPair(WorldState& state, Index pair) {
  const PairSlot& slot = state.pairs[at(pair)];
  const bool movesA = isDynamic(state.bodies[at(slot.bodyA)]);
  const bool movesB = isDynamic(state.bodies[at(slot.bodyB)]);
  Index island = islandOf(state, movesA ? slot.bodyA : slot.bodyB);
  if (movesA && movesB) {
    const Index other = islandOf(state, slot.bodyB);
    if (other != island) {
      const std::size_t here = state.islands[at(island)].bodies.size();
      const std::size_t there = state.islands[at(other)].bodies.size();
      join(state, here < there ? island : other, here < there ? other : island);
      island = state.bodies[at(slot.bodyB)].island;
    }
  }
  addPair(state, island, pair);
}

void releasePair(WorldState& state, Index pair) {
  PairSlot& slot = state.pairs[at(pair)];
  IslandSlot& island = state.islands[at(slot.island)];
  const Index moved = takeOut(island.pairs, slot.islandAt);
  if (moved != kNone) state.pairs[at(moved)].islandAt = slot.islandAt;
  slot.island = slot.islandAt = kNone;
  island.mustSplit = island.unsorted = true;
  island.still = false;
}

void splitIslands(WorldState& state) {
  for (std::size_t i = state.awakeIslands.size(); i-- > 0;) {
    const Index island = state.awakeIslands[i];
    if (state.islands[at(island)].mustSplit) split(state, island);
  }
  for (const Index island : state.awakeIslands) {
    IslandSlot& slot = state.islands[at(island)];
    if (slot.unsorted) sortIsland(state, slot);
  }
}

void listBody(WorldState& state, Index body) {
  state.bodies[at(body)].awakeAt = static_cast<Index>(state.awakeBodies.size());
  state.awakeBodies.push_back(body);
}

void unlistBody(WorldState& state, Index body) {
  BodySlot& slot = state.bodies[at(body)];
  const Index moved = takeOut(state.awakeBodies, slot.awakeAt);
  if (moved != kNone) state.bodies[at(moved)].awakeAt = slot.awakeAt;
  slot.awakeAt = kNone;
}

void listPair(WorldState& state, Index pair) {
  PairSlot& slot = state.pairs[at(pair)];
  const auto isAwake = [&](Index body) { return state.bodies[at(body)].awakeAt != kNone; };
  const bool wanted = slot.alive && (isAwake(slot.bodyA) || isAwake(slot.bodyB));
  if (wanted == (slot.awakeAt != kNone)) return;
  if (wanted) {
    slot.awakeAt = static_cast<Index>(state.awakePairs.size());
    state.awakePairs.push_back(pair);
    return;
  }
  const Index moved = takeOut(state.awakePairs, slot.awakeAt);
  if (moved != kNone) state.pairs[at(moved)].awakeAt = slot.awakeAt;
  slot.awakeAt = kNone;
}

namespace {

void listPairsOf(WorldState& state, Index body) {
  for (const Index shape : state.bodies[at(body)].shapes) {
    state.broadPhase.pairs().forEachOf(
        shape, [&](std::int32_t pair, std::int32_t) { listPair(state, pair); });
  }
}

void watchAnew(BodySlot& body) {
  body.restTime = 0;
  body.restSpeed = 0;
  body.restHalf = false;
  body.restStart = body.pose;
}

// The plain function says who wakes. It goes through all contacts for each link of a chain, and an
// island that is in order wakes as a whole: nobody else needs to ask.
void askWhoWakes(WorldState& state, const IslandSlot& island) {
  describe(state, island);
  Workspace& work = state.work;
  work.asleep.assign(work.flags.size(), 1);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    if (work.asleep[i] != 0) {
      wake(static_cast<Index>(i), work.links, work.flags, work.asleep);
    }
  }
}

}  // namespace

void wakeIsland(WorldState& state, Index island) {
  IslandSlot& slot = state.islands[at(island)];
  if (slot.awake) return;
  ++state.counters.islandsWoken;
  slot.awake = true;
  slot.still = false;
  slot.awakeAt = static_cast<Index>(state.awakeIslands.size());
  state.awakeIslands.push_back(island);
  if (takesPlainPath()) askWhoWakes(state, slot);
  for (std::size_t i = 0; i < slot.bodies.size(); ++i) {
    BodySlot& body = state.bodies[at(slot.bodies[i])];
    body.asleep = false;
    body.clock = 0;
    --state.sleeping;
    watchAnew(body);
    listBody(state, slot.bodies[i]);
  }
  for (const Index body : slot.bodies) listPairsOf(state, body);
}

void wakeBody(WorldState& state, Index body) {
  BodySlot& slot = state.bodies[at(body)];
  if (slot.island != kNone) {
    wakeIsland(state, slot.island);
    state.islands[at(slot.island)].still = false;
  }
  watchAnew(slot);
}

void putToSleep(WorldState& state, Index island) {
  ++state.counters.islandsPutToSleep;
  IslandSlot& slot = state.islands[at(island)];
  unlistIsland(state, island);
  slot.awake = false;
  for (const Index index : slot.bodies) {
    BodySlot& body = state.bodies[at(index)];
    body.asleep = true;
    body.velocity = Velocity();
    body.acceleration = body.turning = Vector3::Zero();
    ++state.sleeping;
    unlistBody(state, index);
    for (const Index shape : body.shapes) makeStale(state, shape);
  }
  for (const Index body : slot.bodies) listPairsOf(state, body);
}

void leaveIsland(WorldState& state, Index body) {
  BodySlot& slot = state.bodies[at(body)];
  if (slot.island == kNone) return;
  std::vector<Index>& bodies = state.islands[at(slot.island)].bodies;
  bodies.erase(std::find(bodies.begin(), bodies.end(), body));
  if (bodies.empty()) endIsland(state, slot.island);
  slot.island = kNone;
}

namespace {

// The way of the farthest point of a body between two poses: at most that of the centre and a turn.
Real wayBetween(const BodySlot& body, const Pose& from, const Pose& to) {
  const Real turned = (to.R_WB - from.R_WB).norm() / std::sqrt(2.0);
  return (to.p_WB - from.p_WB).norm() + body.reach * turned;
}

// Watches a body for rest. Returns whether it may sleep by now.
bool watch(const WorldState& state, BodySlot& body, Real dt) {
  const WorldSettings& settings = state.settings;
  body.restTime += dt;
  const Real speed = body.velocity.linear.norm() + body.reach * body.velocity.angular.norm();
  body.restSpeed = std::max(body.restSpeed, speed);
  if (!body.restHalf && body.restTime >= settings.sleepTime / 2) {
    body.restHalf = true;
    body.restMiddle = body.pose;
  }
  if (body.restTime < settings.sleepTime) return false;
  const RestWatch seen{wayBetween(body, body.restStart, body.restMiddle),
                       wayBetween(body, body.restMiddle, body.pose), body.restSpeed};
  const RestLimits limits{settings.sleepSpeed, settings.sleepDistance, 1e-6};
  if (maySleep(seen, limits)) return true;
  // The second half is the first one of the next look.
  body.restTime -= settings.sleepTime / 2;
  body.restStart = body.restMiddle;
  body.restMiddle = body.pose;
  body.restSpeed = speed;
  return false;
}

bool heldByMoving(const WorldState& state, const IslandSlot& island) {
  return std::any_of(island.pairs.begin(), island.pairs.end(), [&](Index pair) {
    const BodySlot& a = state.bodies[at(state.pairs[at(pair)].bodyA)];
    const BodySlot& b = state.bodies[at(state.pairs[at(pair)].bodyB)];
    const auto carries = [](const BodySlot& body) {
      return body.kind == BodyKind::kinematic &&
             (body.velocity.linear != Vector3::Zero() || body.velocity.angular != Vector3::Zero());
    };
    return carries(a) || carries(b);
  });
}

}  // namespace

void sleepIslands(WorldState& state, Real dt) {
  if (!state.settings.sleeping) return;
  for (std::size_t i = state.awakeIslands.size(); i-- > 0;) {
    const Index island = state.awakeIslands[i];
    const IslandSlot& slot = state.islands[at(island)];
    bool all = true;
    for (const Index body : slot.bodies) {
      const bool one = watch(state, state.bodies[at(body)], dt);
      all = all && one && state.bodies[at(body)].maySleep;
    }
    if (all && !slot.mustSplit && !heldByMoving(state, slot)) putToSleep(state, island);
  }
}

}  // namespace carom::world
