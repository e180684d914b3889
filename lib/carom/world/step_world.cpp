#include "carom/world/step_world.hpp"

#include <algorithm>

#include "carom/motion/careful_sum.hpp"
#include "carom/world/advance_island.hpp"
#include "carom/world/crowd.hpp"
#include "carom/world/islands.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

void beginStep(WorldState& state, Real dt) {
  state.counters = Counters();
  state.begun.clear();
  // What ended between the steps has not been seen yet.
  state.ended.erase(state.ended.begin(),
                    state.ended.begin() + static_cast<std::ptrdiff_t>(state.endedBefore));
  state.impacts.clear();
  state.partStart = 0;
  // What a step of one length leaves as it is, one of another may change.
  if (dt != state.lastStep) {
    for (const Index island : state.awakeIslands) state.islands[at(island)].still = false;
  }
  state.lastStep = dt;
  // What would be over within the shortest time; or within the step, if nobody looks inside it: a
  // body that bounced would fall on all through it, and deeper from step to step.
  const WorldSettings& settings = state.settings;
  const Real fall = dt * settings.gravity.norm() / 2;
  state.slowestImpact = settings.shortestBounce * fall + 1e-12;
  state.slowestBounce = settings.continuous ? state.slowestImpact : fall + 1e-12;
}

namespace {

// Bodies that no pair holds, and those that only their own velocity moves.
void advanceFree(WorldState& state, Real dt) {
  for (const Index index : state.awakeBodies) {
    BodySlot& body = state.bodies[at(index)];
    if (body.island != kNone) continue;
    body.isFree = true;
    body.acceleration = freeAcceleration(state, body);
    moveBody(state, index, dt, true);
    ++state.counters.bodiesFree;
  }
}

}  // namespace

namespace {

// Whether a pair has begun to touch in this step, or has ended.
bool hasChanged(const WorldState& state, const PairSlot& pair) {
  if (pair.madeAt < 0) return false;  // kept: as it was
  if (pair.leftOut && !pair.touches) return false;
  bool touches = false;
  for (int k = 0; k < pair.manifold.count; ++k) touches = touches || isClosed(state, pair, k);
  return touches != pair.touches;
}

}  // namespace

void reportContacts(WorldState& state) {
  constexpr std::size_t kFew = 128;  // are not worth a second thread
  std::vector<std::uint8_t>& changed = state.work.seen;
  changed.resize(state.awakePairs.size());
  shareOut(state, state.awakePairs.size(), kFew, [&](std::size_t i) {
    fetchAhead(state, state.awakePairs, i);
    changed[i] = hasChanged(state, state.pairs[at(state.awakePairs[i])]) ? 1 : 0;
  });
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (changed[i] == 0) continue;
    PairSlot& pair = state.pairs[at(state.awakePairs[i])];
    pair.touches = !pair.touches;
    (pair.touches ? state.begun : state.ended).push_back(eventOf(state, pair));
  }
  const auto byIds = [](const ContactEvent& a, const ContactEvent& b) {
    return a.shapeA != b.shapeA ? a.shapeA < b.shapeA : a.shapeB < b.shapeB;
  };
  std::sort(state.begun.begin(), state.begun.end(), byIds);
  std::sort(state.ended.begin(), state.ended.end(), byIds);
  // Impacts of one pair at one time stay in the order in which they were found. A sort that is
  // stable takes memory; so their numbers decide.
  for (std::size_t i = 0; i < state.impacts.size(); ++i) {
    state.impacts[i].number = static_cast<std::int32_t>(i);
  }
  std::sort(state.impacts.begin(), state.impacts.end(),
            [](const ImpactEvent& a, const ImpactEvent& b) {
              if (a.time != b.time) return a.time < b.time;
              if (a.shapeA != b.shapeA) return a.shapeA < b.shapeA;
              return a.shapeB != b.shapeB ? a.shapeB < b.shapeB : a.number < b.number;
            });
  state.endedBefore = state.ended.size();
}

void countBodies(WorldState& state) {
  Counters& counters = state.counters;
  counters.bodiesAwake = static_cast<std::int64_t>(state.awakeBodies.size());
  counters.bodiesAsleep = state.sleeping;
  counters.islandsAwake = static_cast<std::int64_t>(state.awakeIslands.size());
  counters.islandsAsleep = state.islandCount - counters.islandsAwake;
  counters.pairsAsleep = state.broadPhase.pairs().size() - counters.pairsAwake;
}

namespace {

//! [step]
void goPart(WorldState& state, Real dt) {
  updatePairs(state, dt);
  updateManifolds(state, dt);
  splitIslands(state);
  countBodies(state);
  advanceIslands(state, dt);
  // Kinematic bodies last: islands ask where they are at any time.
  advanceFree(state, dt);
  reportContacts(state);
  sleepIslands(state, dt);
}
//! [step]

}  // namespace

//! [parts]
void stepWorld(WorldState& state, Real dt) {
  const int parts = partsForCrowd(state, dt);
  beginStep(state, dt / parts);
  for (int part = 0; part < parts; ++part) {
    state.partStart = dt * part / parts;
    goPart(state, dt / parts);
  }
  state.counters.parts = parts;
  addCarefully(state.time, state.lostTime, dt);
}
//! [parts]

}  // namespace carom::world
