#include "carom/world/advance_island.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/world/advance_pile.hpp"
#include "carom/world/contact_phase.hpp"
#include "carom/world/find_islands.hpp"
#include "carom/world/islands.hpp"
#include "carom/world/keep_energy.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/next_contact.hpp"
#include "carom/world/project_positions.hpp"
#include "carom/world/project_velocities.hpp"
#include "carom/world/resolve_impacts.hpp"
#include "carom/world/stay_in_room.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// Whether more contacts of an island are closed than some number. Large islands are not gone through.
bool hasMoreClosed(const WorldState& state, const IslandSlot& island, int most) {
  int closed = 0;
  for (const Index pair : island.pairs) {
    const PairSlot& slot = state.pairs[at(pair)];
    for (int i = 0; i < slot.manifold.count; ++i) closed += isClosed(state, slot, i) ? 1 : 0;
    if (closed > most) return true;
  }
  return false;
}

// The pairs of this island that belong to a set of bodies, each once, in the order of their shapes.
void pairsOfSet(WorldState& state, Index island) {
  Workspace& work = state.work;
  work.setPairs.clear();
  if (work.set.size() == state.islands[at(island)].bodies.size()) {
    work.setPairs = state.islands[at(island)].pairs;
    return;
  }
  for (const Index body : work.set) {
    for (const Index shape : state.bodies[at(body)].shapes) {
      state.broadPhase.pairs().forEachOf(shape, [&](std::int32_t pair, std::int32_t) {
        if (state.pairs[at(pair)].island == island) work.setPairs.push_back(pair);
      });
    }
  }
  std::sort(work.setPairs.begin(), work.setPairs.end(),
            [&](Index p, Index q) { return state.pairs[at(p)].order < state.pairs[at(q)].order; });
  work.setPairs.erase(std::unique(work.setPairs.begin(), work.setPairs.end()), work.setPairs.end());
}

// Whether all dynamic bodies of a pair are in the set: they are at its time.
bool isInner(const WorldState& state, const PairSlot& pair, Real time) {
  const auto isHere = [&](Index body) {
    const BodySlot& slot = state.bodies[at(body)];
    return !isDynamic(slot) || (slot.clock == time && slot.local >= 0);
  };
  return isHere(pair.bodyA) && isHere(pair.bodyB);
}

// Bodies that touch and do not part move together from now on.
void findClusters(WorldState& state) {
  Workspace& work = state.work;
  for (const Index body : work.set) state.bodies[at(body)].cluster = body;
  work.links.clear();
  for (const WorkPatch& one : work.patches) {
    const auto isMember = [&](int local) { return at(local) < work.set.size(); };
    if (isMember(one.patch.bodyA) && isMember(one.patch.bodyB)) {
      work.links.push_back(pairOf(one.patch.bodyA, one.patch.bodyB));
    }
  }
  if (work.links.empty()) return;
  work.flags.assign(work.set.size(), 1);
  work.labels.resize(work.set.size());
  findIslands(work.links, work.flags, work.labels);
  for (std::size_t i = 0; i < work.set.size(); ++i) {
    state.bodies[at(work.set[i])].cluster = work.set[at(work.labels[i])];
  }
}

// How far the next phase may go. Forces are taken to be even in a phase, which is right to the
// square of its length. That is enough for bodies that rest, slide or roll; one that turns about a
// corner or an edge falls faster and faster, and takes short phases.
Real endOfPhase(const WorldState& state, std::span<const Index> pairs, Real time, Real dt) {
  // More points are a heap, in which a step is long for other reasons.
  constexpr int kFewPoints = 8;
  constexpr Real kShortest = 1.0 / 16;  // of the step [1]
  // Where the error chooses the steps they are short enough, and must differ in nothing else.
  if (!state.settings.trapezoidal || state.longSteps) return dt;
  const Real turn = state.settings.phaseTurn;
  int points = 0;
  Real rate = 0;
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    int closed = 0;
    for (int i = 0; i < pair.manifold.count; ++i) closed += isClosed(state, pair, i) ? 1 : 0;
    points += closed;
    if (closed == 0) continue;
    for (const auto& [shape, body] :
         {std::pair(pair.shapeA, pair.bodyA), {pair.shapeB, pair.bodyB}}) {
      const ShapeSlot& slot = state.shapes[at(shape)];
      const BodySlot& owner = state.bodies[at(body)];
      if (!isDynamic(owner) || isCentredBall(slot)) continue;
      rate = std::max(rate, owner.velocity.angular.norm() + dt * owner.turning.norm());
    }
  }
  const Real left = dt - time;
  if (points > kFewPoints || !(rate * left > turn)) return dt;
  const Real most = std::max(Real(1), std::round(left / (kShortest * dt)));
  return time + left / std::min(most, std::ceil(rate * left / turn));
}

// Something has happened to the bodies of the set, who are all at this time: impacts, then what
// they do until the end of the step, and when the next thing happens to them.
// Returns whether their contacts settled.
bool settle(WorldState& state, Index island, Real time, Real dt, bool bounce) {
  Workspace& work = state.work;
  pairsOfSet(state, island);
  for (const Index index : state.islands[at(island)].bodies) state.bodies[at(index)].local = kNone;
  for (std::size_t i = 0; i < work.set.size(); ++i) {
    state.bodies[at(work.set[i])].local = static_cast<Index>(i);
  }
  std::vector<Index>& inner = work.innerPairs;
  inner.clear();
  for (const Index index : work.setPairs) {
    PairSlot& pair = state.pairs[at(index)];
    pair.stop = pair.renew = kNever;
    pair.bySoftSteps = false;
    if (!isInner(state, pair, time)) continue;
    makeManifold(state, index, time, dt - time);
    inner.push_back(index);
  }
  // Impacts may bring neighbours to collide at once; rounds end when nothing approaches.
  int& knocks = state.islands[at(island)].knocks;
  if (resolveImpacts(state, work.set, inner, time, bounce)) ++knocks;
  PhaseTask phase{.bodies = work.set, .pairs = inner, .start = time, .end = dt};
  // What hits again and again, or does not settle, is not tried in pieces.
  constexpr int kFewKnocks = 1;
  if (knocks <= kFewKnocks) phase.end = endOfPhase(state, inner, time, dt);
  bool settled = solvePhase(state, phase);
  if (!settled) knocks += kFewKnocks + 1;
  // What stood still until now begins to turn.
  const Real end = knocks <= kFewKnocks ? endOfPhase(state, inner, time, dt) : dt;
  if (phase.end == dt ? end < dt : end == dt) {
    phase.end = end;
    settled = solvePhase(state, phase);
  }
  if (phase.end < dt) {
    for (const WorkPatch& one : work.patches) state.pairs[at(one.pair)].renew = phase.end;
  }
  findClusters(state);
  for (const Index pair : work.setPairs) {
    state.pairs[at(pair)].next = nextContact(state, pair, time, dt);
  }
  return settled;
}

struct Event {
  Real time = kNever;
  Index pair = kNone;
  bool stops = false;
};

Event nextEvent(const WorldState& state, const IslandSlot& island) {
  Event event;
  for (const Index pair : island.pairs) {
    const PairSlot& slot = state.pairs[at(pair)];
    if (slot.next < event.time) event = {slot.next, pair, false};
    if (slot.stop < event.time) event = {slot.stop, pair, true};
    if (slot.renew < event.time) event = {slot.renew, pair, false};
  }
  return event;
}

// The bodies that move together with those of a pair.
void setOfPair(WorldState& state, const IslandSlot& island, const PairSlot& pair) {
  Workspace& work = state.work;
  work.set.clear();
  const Index a = state.bodies[at(pair.bodyA)].cluster, b = state.bodies[at(pair.bodyB)].cluster;
  const bool movesA = isDynamic(state.bodies[at(pair.bodyA)]);
  const bool movesB = isDynamic(state.bodies[at(pair.bodyB)]);
  for (const Index body : island.bodies) {
    const Index cluster = state.bodies[at(body)].cluster;
    if ((movesA && cluster == a) || (movesB && cluster == b)) work.set.push_back(body);
  }
}

void advanceAtOnce(WorldState& state, Index index, Real start, Real end) {
  const IslandSlot& island = state.islands[at(index)];
  resolveAtOnce(state, island.bodies, island.pairs, start, end - start);
  solvePhase(state, {.bodies = island.bodies,
                     .pairs = island.pairs,
                     .start = start,
                     .end = end,
                     .speculative = true});
}

bool bounces(const WorldState& state, const IslandSlot& island) {
  return std::any_of(island.pairs.begin(), island.pairs.end(),
                     [&](Index pair) { return state.pairs[at(pair)].restitution > 0; });
}

bool rubs(const WorldState& state, const IslandSlot& island) {
  return std::any_of(island.pairs.begin(), island.pairs.end(),
                     [&](Index pair) { return state.pairs[at(pair)].friction > 0; });
}

// How many events of a step are worth their while. Without friction impacts come to an end; in a heap
// that settles they come ever faster. Where something bounces more of them have their moments, but
// among many that rattle a step of thousands is no more right than one of hundreds.
std::size_t eventsWorth(const WorldState& state, const IslandSlot& island) {
  constexpr std::size_t kFew = 64, kEach = 2, kEachBounce = 8;
  if (!rubs(state, island)) return std::numeric_limits<std::size_t>::max();
  const std::size_t each = bounces(state, island) ? kEachBounce : kEach;
  return kFew + each * island.bodies.size();
}

constexpr std::size_t kFewBodies = 8;  // are always worth their events, if there are no more
constexpr std::size_t kCrowd = 128;    // awake bodies; more are some of a crowd

bool isOfBalls(const WorldState& state, const IslandSlot& island) {
  return std::all_of(island.pairs.begin(), island.pairs.end(), [&](Index index) {
    const PairSlot& pair = state.pairs[at(index)];
    return isRound(state.shapes[at(pair.shapeA)]) && isRound(state.shapes[at(pair.shapeB)]);
  });
}

// Whether more than a share of an island's bodies is faster than some steps of free fall make them.
bool moves(const WorldState& state, const IslandSlot& island, Real steps, Real share) {
  const Real fast = steps * state.settings.gravity.norm() * state.lastStep;
  const auto isFast = [&](Index body) {
    return state.bodies[at(body)].velocity.linear.squaredNorm() > fast * fast;
  };
  const auto moving = std::count_if(island.bodies.begin(), island.bodies.end(), isFast);
  return static_cast<Real>(moving) > share * static_cast<Real>(island.bodies.size());
}

// Whether an island is one of many that a heap of balls has fallen into and that roll on. If it was
// tried again by events now and then, all would be in the same step.
bool rollsInCrowd(const WorldState& state, const IslandSlot& island) {
  return !state.longSteps && state.awakeBodies.size() > kCrowd &&
         island.bodies.size() >= kFewBodies && moves(state, island, 1, 0.5) &&
         isOfBalls(state, island);
}

// Whether an island may be a pile for what it takes otherwise. Bounces want their moments; without
// friction sweeps come to an end; what is small and stands may stand; and of a few bodies each
// moment counts, unless they are some of a crowd. What soft steps leave of overlap is too much for
// boxes and hulls that go on by events or stand still: only their heaps may be piles, and what moves
// in a crowd.
bool mayBePile(const WorldState& state, const IslandSlot& island) {
  const bool inCrowd = state.awakeBodies.size() > kCrowd;
  if (!inCrowd && island.bodies.size() < kFewBodies) return false;
  if (!rubs(state, island) || bounces(state, island)) return false;
  const bool ofBalls = isOfBalls(state, island);
  const bool isHeap = hasMoreClosed(state, island, state.settings.eventContacts);
  if (ofBalls ? isHeap || inCrowd : !isHeap && !inCrowd) return ofBalls;
  return ofBalls ? moves(state, island, 1, 0.5) : moves(state, island, 0.1, 0.1);
}

// What a pile would cost, in visits of a row.
std::int64_t workOfPile(const WorldState& state, const IslandSlot& island) {
  constexpr std::int64_t kBody = 16;
  std::int64_t points = 0;
  for (const Index pair : island.pairs) points += state.pairs[at(pair)].manifold.count;
  return kBody * static_cast<std::int64_t>(island.bodies.size()) +
         points * state.settings.shortSteps;
}

// What has been done so far, in visits of a row.
std::int64_t workDone(const Counters& counters) {
  constexpr std::int64_t kManifold = 8, kSearch = 16, kImpact = 16;
  return counters.rowsSolved + counters.directWork + kManifold * counters.manifoldsMade +
         kSearch * counters.firstContacts + kImpact * counters.impacts;
}

// Whether an island has taken so much in a step that it had better be a pile.
bool isTooDear(const WorldState& state, const IslandSlot& island, std::int64_t before) {
  const std::int64_t work = workDone(state.counters) - before;
  return work > state.settings.pileWork * workOfPile(state, island) && mayBePile(state, island);
}

// Returns false if the contacts do not settle; then nothing but velocities has changed.
bool advanceByEvents(WorldState& state, Index index, Real start, Real dt, int& events) {
  const IslandSlot& island = state.islands[at(index)];
  Workspace& work = state.work;
  work.set = island.bodies;
  state.islands[at(index)].knocks = 0;
  if (!settle(state, index, start, dt, true)) return false;
  // After so many events bodies stop bouncing; after as many again they go where they go.
  const std::size_t most =
      static_cast<std::size_t>(state.settings.eventsPerBody) * (island.bodies.size() + 1);
  constexpr int kHeapFor = 8;  // steps that an island of more events is taken at once
  const std::size_t worth = eventsWorth(state, island);
  const std::int64_t workBefore = workDone(state.counters);
  for (std::size_t count = 0; count < 2 * most; ++count) {
    const Event event = nextEvent(state, island);
    if (!(event.time < dt)) break;
    if (!state.longSteps && (count >= worth || isTooDear(state, island, workBefore))) {
      for (const Index body : island.bodies) moveBody(state, body, event.time);
      advanceAtOnce(state, index, event.time, dt);
      state.islands[at(index)].hardFor = kHeapFor;
      break;
    }
    ++events;
    PairSlot& pair = state.pairs[at(event.pair)];
    setOfPair(state, island, pair);
    for (const Index body : work.set) moveBody(state, body, event.time);
    if (event.stops) {
      pair.sticks = true;
      ++state.counters.slipChanges;
    }
    settle(state, index, event.time, dt, count < most);
  }
  return true;
}

// Whether it is worth the while to look if a step changes anything: nothing is fast, and nothing
// counts the steps.
bool mayBeStill(const WorldState& state, const IslandSlot& island) {
  if (!state.settings.keepStill || island.hardFor > 0 || island.strayFor > 0) return false;
  const Real slow = slowSpeed(state);
  for (const Index index : island.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    if (body.anchor || body.velocity.linear.squaredNorm() > slow * slow) return false;
  }
  return std::none_of(island.pairs.begin(), island.pairs.end(), [&](Index pair) {
    return state.bodies[at(state.pairs[at(pair)].bodyA)].kind == BodyKind::kinematic ||
           state.bodies[at(state.pairs[at(pair)].bodyB)].kind == BodyKind::kinematic;
  });
}

void remember(WorldState& state, const IslandSlot& island) {
  Workspace& work = state.work;
  work.bodiesBefore.clear();
  work.pairsBefore.clear();
  for (const Index index : island.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    work.bodiesBefore.push_back({body.position, body.orientation, body.velocity, body.turning});
  }
  for (const Index index : island.pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    work.pairsBefore.push_back({pair.force, pair.rub, pair.twist, pair.sticks});
  }
}

// Whether everything that the next step starts from is what this one started from. Steps with the
// same start end alike: nothing will change until somebody interferes.
bool isAsRemembered(const WorldState& state, const IslandSlot& island) {
  const Workspace& work = state.work;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodySlot& body = state.bodies[at(island.bodies[i])];
    const BodyBefore& before = work.bodiesBefore[i];
    const Quaternion &q = body.orientation, &p = before.orientation;
    if (body.anchor || body.position != before.position || q.w != p.w || q.x != p.x || q.y != p.y ||
        q.z != p.z || body.velocity.linear != before.velocity.linear ||
        body.velocity.angular != before.velocity.angular || body.turning != before.turning) {
      return false;
    }
  }
  for (std::size_t i = 0; i < island.pairs.size(); ++i) {
    const PairSlot& pair = state.pairs[at(island.pairs[i])];
    const PairBefore& before = work.pairsBefore[i];
    if (pair.force != before.force || pair.rub != before.rub || pair.twist != before.twist ||
        pair.sticks != before.sticks) {
      return false;
    }
  }
  return island.hardFor == 0;
}

// Whether an island is solved by soft steps: many contacts, so many bodies that plastic impacts
// cannot be looked for one by one, or one of the last steps took too much.
bool isPile(const WorldState& state, const IslandSlot& island) {
  if (hasMoreClosed(state, island, state.settings.pileContacts)) return true;
  if (static_cast<int>(island.bodies.size()) > state.settings.pileBodies) {
    return !bounces(state, island);
  }
  return (island.pileFor > 0 || (island.isPile && rollsInCrowd(state, island))) &&
         mayBePile(state, island);
}

// Looks whether an island that changes is a pile in this step; its manifolds are there after that.
bool beginIsland(WorldState& state, Index index, Real start, Real end) {
  IslandSlot& island = state.islands[at(index)];
  // Pairs of an island that was still until now have no manifold of this step yet.
  const bool mayLack = start > 0 || state.longSteps || state.counters.pairsKept > 0;
  for (std::size_t i = 0; mayLack && i < island.pairs.size(); ++i) {
    makeManifold(state, island.pairs[i], start, end - start);
  }
  island.isPile = isPile(state, island);
  if (island.isPile) island.pileFor = std::max(0, island.pileFor - 1);
  return island.isPile;
}

// Steps an island that is no pile.
IslandRun advanceUsual(WorldState& state, Index index, Real start, Real end) {
  IslandRun run;
  IslandSlot& island = state.islands[at(index)];
  // What a pile carries along, or leaves out, is not good enough here.
  for (const Index pair : island.pairs) {
    const PairSlot& slot = state.pairs[at(pair)];
    if (slot.carried || slot.narrow) remakeManifold(state, pair, start, end - start);
  }
  const std::int64_t workBefore = workDone(state.counters);
  const bool isWatched = mayBeStill(state, island);
  if (isWatched) remember(state, island);
  const std::size_t impacts = state.impacts.size();
  rememberStarts(state, island.bodies);
  watchEnergy(state, island);
  if (state.settings.projectPositions) projectPositions(state, island.bodies, island.pairs);
  // What was not solved directly is hardly so in the next step.
  constexpr int kStrayFor = 8;
  const bool mayFactor = state.work.mayFactor = island.strayFor == 0;
  constexpr std::int64_t kSolutions = 4;  // that the budget of all events of a step is enough for
  state.work.rowsLeft = kSolutions * state.settings.rowBudget;
  // An island whose contacts do not settle is not tried again in each step.
  constexpr int kHardFor = 60;
  run.byEvents = state.settings.locateEvents && island.hardFor == 0 &&
                 !hasMoreClosed(state, island, state.settings.eventContacts);
  island.hardFor = std::max(0, island.hardFor - 1);
  if (run.byEvents && !advanceByEvents(state, index, start, end, run.events)) {
    island.hardFor = kHardFor;
    run.byEvents = false;
  }
  if (!run.byEvents) {
    state.work.rowsLeft = kSolutions * state.settings.rowBudget;
    advanceAtOnce(state, index, start, end);
  }
  if (isTooDear(state, island, workBefore)) {
    island.pileFor = state.settings.pileSteps;
    ++state.counters.islandsTooDear;
  }
  const bool strayed = mayFactor && !state.work.mayFactor;
  island.strayFor = strayed ? kStrayFor : std::max(0, island.strayFor - 1);
  if (state.impacts.size() != impacts) {
    for (const Index body : island.bodies) stayInRoom(state, body, end);
  }
  for (const Index body : island.bodies) moveBody(state, body, end, true);
  if (state.longSteps && run.byEvents) {
    projectEnd(state, island.bodies, island.pairs, end);
  } else if (state.settings.projectPositions) {
    projectRounds(state, island.bodies, island.pairs, end);
  }
  holdMiddles(state, island.bodies, island.pairs, {start, end});
  keepEnergy(state, island, state.work.starts, end - start);
  island.still = isWatched && state.impacts.size() == impacts && isAsRemembered(state, island);
  return run;
}

// Steps piles. Nobody follows their contacts, and who is pressed into a wall by others stays in
// front of it by his middle.
void advanceInRoom(WorldState& state, std::span<const Index> piles, Real start, Real end) {
  Workspace& work = state.work;
  work.set.clear();
  work.setPairs.clear();
  constexpr std::size_t kFew = 4;  // are not worth a second thread
  shareOut(state, piles.size(), kFew,
           [&](std::size_t i) { watchEnergy(state, state.islands[at(piles[i])]); });
  std::vector<std::size_t>& firsts = state.pile.firsts;
  firsts.clear();
  for (const Index index : piles) {
    const IslandSlot& island = state.islands[at(index)];
    firsts.push_back(work.set.size());
    work.set.insert(work.set.end(), island.bodies.begin(), island.bodies.end());
    for (const Index pair : island.pairs) {
      if (!isDynamic(state.bodies[at(state.pairs[at(pair)].bodyA)])) work.setPairs.push_back(pair);
    }
  }
  rememberStarts(state, work.set);
  advancePiles(state, piles, start, end);
  holdMiddles(state, work.set, work.setPairs, {start, end});
  std::vector<Real>& shares = state.pile.shares;
  shares.resize(piles.size());
  shareOut(state, piles.size(), kFew, [&](std::size_t i) {
    const IslandSlot& island = state.islands[at(piles[i])];
    const auto starts = std::span<const Pose>(work.starts).subspan(firsts[i], island.bodies.size());
    shares[i] = keptShare(state, island, starts, end - start);
  });
  for (std::size_t i = 0; i < piles.size(); ++i) {
    if (shares[i] == kAllSpeed) continue;
    slowDown(state, state.islands[at(piles[i])], shares[i], end - start);
  }
}

}  // namespace

IslandRun advanceIsland(WorldState& state, Index index, Real start, Real end) {
  if (state.islands[at(index)].still) {
    ++state.counters.islandsStill;
    return {};
  }
  if (!beginIsland(state, index, start, end)) return advanceUsual(state, index, start, end);
  advanceInRoom(state, std::span(&index, 1), start, end);
  return {.isPile = true};
}

void advanceIslands(WorldState& state, Real dt) {
  std::vector<Index>& piles = state.pile.islands;
  piles.clear();
  for (const Index index : state.awakeIslands) {
    if (state.islands[at(index)].still) {
      ++state.counters.islandsStill;
    } else if (beginIsland(state, index, 0, dt)) {
      piles.push_back(index);
    } else {
      advanceUsual(state, index, 0, dt);
    }
  }
  advanceInRoom(state, piles, 0, dt);
}

}  // namespace carom::world
