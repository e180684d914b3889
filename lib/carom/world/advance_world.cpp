#include "carom/world/advance_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/detection/bounds.hpp"
#include "carom/motion/careful_sum.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/world/advance_island.hpp"
#include "carom/world/islands.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/step_world.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

constexpr int kMostTries = 6;          // of one time, in 1, 2, ... steps
constexpr Real kUsualStep = 1.0 / 60;  // long steps are not cut below it for the sake of pairs [s]

// What is wanted of a time.
struct Goal {
  Real tolerance = 0;  // [m]
  Real duration = 0;   // [s]
  Real left = 0;       // from the start of the long step [s]
};

// Bodies that are stepped together: those of an island, or one that nothing holds.
struct Group {
  Index island = kNone;
  std::span<const Index> bodies;
  std::span<const Index> pairs;
};

// --- Keeping and putting back

void keep(const WorldState& state, const Group& group, std::vector<SavedBody>& bodies,
          std::vector<PairSlot>& pairs) {
  for (const Index index : group.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    SavedBody saved{body.position, body.orientation, body.velocity, body.clock, {}};
    if (body.anchor) saved.anchor = state.anchors[*body.anchor];
    bodies.push_back(saved);
  }
  for (const Index pair : group.pairs) pairs.push_back(state.pairs[at(pair)]);
}

void putBack(WorldState& state, const Group& group, const SavedBody* bodies,
             const PairSlot* pairs) {
  for (const Index index : group.bodies) {
    BodySlot& body = state.bodies[at(index)];
    const SavedBody& saved = *bodies++;
    dropAnchor(state, body);
    if (saved.anchor) giveAnchor(state, body, *saved.anchor);
    body.position = saved.position;
    body.orientation = saved.orientation;
    body.velocity = saved.velocity;
    body.clock = saved.clock;
    refreshPose(body);
  }
  for (const Index pair : group.pairs) state.pairs[at(pair)] = *pairs++;
}

// --- Tries

// Whether a body that nothing touches moves exactly, however far.
bool isExact(const WorldState& state, const BodySlot& body) {
  if (body.torque != Vector3::Zero()) return false;
  return body.turnsEvenly || state.settings.exactRotation || !state.settings.gyroscopic;
}

// Goes a time in some steps of equal length. Returns what happened on the way.
IslandRun goInSteps(WorldState& state, const Group& group, Real start, Real end, int count) {
  IslandRun all{.byEvents = true};
  for (int k = 0; k < count; ++k) {
    const Real from = k == 0 ? start : start + (end - start) * k / count;
    const Real to = k + 1 == count ? end : start + (end - start) * (k + 1) / count;
    ++state.counters.subSteps;
    if (group.island == kNone) {
      moveBody(state, group.bodies[0], to, true);
      continue;
    }
    if (from > 0) {
      for (const Index pair : group.pairs) state.pairs[at(pair)].madeAt = -1;
    }
    const IslandRun one = advanceIsland(state, group.island, from, to);
    all.byEvents = all.byEvents && one.byEvents;
    all.isPile = all.isPile || one.isPile;
    all.events += one.events;
  }
  return all;
}

// Where a try has ended.
void noteEnd(const WorldState& state, const Group& group, std::vector<SavedBody>& ends) {
  for (const Index index : group.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    ends.push_back({body.position, body.orientation, body.velocity, body.clock, {}});
  }
}

// The small turn from one orientation to another [rad, world].
Vector3 turnBetween(const Quaternion& from, const Quaternion& to) {
  const Quaternion turn = hamiltonProduct(to, conjugate(from));
  return (turn.w < 0 ? -2.0 : 2.0) * Vector3(turn.x, turn.y, turn.z);
}

// What two ends of a body differ by.
struct Difference {
  Vector3 way = Vector3::Zero();   // [m]
  Vector3 turn = Vector3::Zero();  // [rad]
  Velocity velocity;
};

void addTimes(Difference& sum, Real weight, const SavedBody& from, const SavedBody& to) {
  sum.way += weight * (to.position - from.position);
  sum.turn += weight * turnBetween(from.orientation, to.orientation);
  sum.velocity.linear += weight * (to.velocity.linear - from.velocity.linear);
  sum.velocity.angular += weight * (to.velocity.angular - from.velocity.angular);
}

// How wrong a difference makes a body at the end, beyond what rounding makes [m].
Real sizeOf(const Difference& d, const BodySlot& body, const SavedBody& end, Real ahead) {
  constexpr Real kRoundings = 64 * std::numeric_limits<Real>::epsilon();
  const Real fast = end.velocity.linear.norm() + end.velocity.angular.norm();
  const Real noise =
      kRoundings * (end.position.cwiseAbs().maxCoeff() + body.reach + 1 + ahead * fast);
  const Real way = d.way.norm() + ahead * d.velocity.linear.norm();
  const Real turn = d.turn.norm() + ahead * d.velocity.angular.norm();
  return std::max(Real(0), std::max(way, turn) - noise);
}

// Weights of the ends of 1, 2, ..., m steps. They add up to one and take away what goes with the
// second to the m-th power of the step: an island's steps are of second order and not symmetric, so
// that odd powers are there as well (extrapolation.hpp has even ones alone).
constexpr std::array<std::array<Real, kMostTries>, kMostTries + 1> kWeights{{
    {},
    {1.0},
    {-1.0 / 3, 4.0 / 3},
    {1.0 / 12, -4.0 / 3, 9.0 / 4},
    {-1.0 / 60, 4.0 / 5, -81.0 / 20, 64.0 / 15},
    {1.0 / 360, -16.0 / 45, 81.0 / 20, -512.0 / 45, 625.0 / 72},
    {-1.0 / 2520, 8.0 / 63, -81.0 / 28, 1024.0 / 63, -15625.0 / 504, 648.0 / 35},
}};

// What the first `count` tries tend to for steps of no length, seen from the last of them.
Difference tendency(const std::vector<SavedBody>& ends, std::size_t bodies, std::size_t body,
                    int count) {
  const std::array<Real, kMostTries>& weights = kWeights[at(count)];
  const SavedBody& last = ends[at(count - 1) * bodies + body];
  Difference sum;
  for (int k = 0; k + 1 < count; ++k)
    addTimes(sum, weights[at(k)], last, ends[at(k) * bodies + body]);
  return sum;
}

// The error of the answer of the first `count` tries: by how much the last of them changed it [m].
Real errorOf(const WorldState& state, const Group& group, int count, bool smooth, Real ahead) {
  const std::vector<SavedBody>& ends = state.work.ends;
  const std::size_t n = group.bodies.size();
  Real worst = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const SavedBody &last = ends[at(count - 1) * n + i], &before = ends[at(count - 2) * n + i];
    Difference change;
    addTimes(change, 1, before, last);
    if (smooth && count > 2) {
      const Difference now = tendency(ends, n, i, count), then = tendency(ends, n, i, count - 1);
      change.way += now.way - then.way;
      change.turn += now.turn - then.turn;
      change.velocity.linear += now.velocity.linear - then.velocity.linear;
      change.velocity.angular += now.velocity.angular - then.velocity.angular;
    }
    worst = std::max(worst, sizeOf(change, state.bodies[at(group.bodies[i])], last, ahead));
  }
  return worst;
}

// Bodies that something held take the place that the tries tend to.
void takeAnswer(WorldState& state, const Group& group, int count) {
  for (std::size_t i = 0; i < group.bodies.size(); ++i) {
    BodySlot& body = state.bodies[at(group.bodies[i])];
    if (body.isFree && isExact(state, body)) continue;
    const Difference way = tendency(state.work.ends, group.bodies.size(), i, count);
    dropAnchor(state, body);
    body.position += way.way;
    if (way.turn != Vector3::Zero()) {
      body.orientation = integrateOrientation(body.orientation, way.turn, 1);
    }
    body.velocity.linear += way.velocity.linear;
    body.velocity.angular += way.velocity.angular;
    refreshPose(body);
  }
}

// What came of the tries of one time.
struct Outcome {
  bool accepted = false;
  Real factor = 1;  // the next time to try, in parts of this one
};

Outcome tryTime(WorldState& state, const Group& group, const Goal& goal, Real start, Real end) {
  Workspace& work = state.work;
  const Real ahead = std::max(Real(1), goal.left - end);
  const std::size_t impacts = state.impacts.size();
  const int hardFor = group.island == kNone ? 0 : state.islands[at(group.island)].hardFor;
  work.tryBodies.clear();
  work.tryPairs.clear();
  work.ends.clear();
  keep(state, group, work.tryBodies, work.tryPairs);

  const std::int64_t rows = state.counters.normalRows;
  IslandRun run = goInSteps(state, group, start, end, 1);
  // A pile goes its usual steps: nobody asks where each of its bodies comes to lie.
  if (run.isPile) return {end - start <= kUsualStep, kUsualStep / (end - start)};
  bool exact = run.byEvents && state.counters.normalRows == rows;
  for (const Index body : group.bodies) exact = exact && isExact(state, state.bodies[at(body)]);
  if (exact) return {true, 4};

  noteEnd(state, group, work.ends);
  bool smooth = state.settings.extrapolation && run.byEvents && run.events == 0;
  Real before = std::numeric_limits<Real>::infinity();
  for (int count = 2; count <= kMostTries; ++count) {
    putBack(state, group, work.tryBodies.data(), work.tryPairs.data());
    if (group.island != kNone) state.islands[at(group.island)].hardFor = hardFor;
    state.impacts.resize(impacts);
    run = goInSteps(state, group, start, end, count);
    noteEnd(state, group, work.ends);
    smooth = smooth && run.byEvents && run.events == 0;
    // What happens on the way gets a share of its own, however short the time around it.
    constexpr Real kSafety = 0.1, kShare = 1.0 / 32;
    const Real part = (end - start) / goal.duration;
    const Real most = kSafety * goal.tolerance * (smooth ? part : std::max(part, kShare));
    const Real error = errorOf(state, group, count, smooth, ahead);
    if (error <= most) {
      if (smooth) takeAnswer(state, group, count);
      constexpr std::array<Real, kMostTries + 1> kFactors{0, 0, 3, 2, 1.4, 1, 0.8};
      return {true, error == 0 ? 4 : smooth ? kFactors[at(count)] : 1};
    }
    if (!smooth || error > before / 4) break;
    before = error;
  }
  return {false, smooth ? 0.4 : 0.5};
}

// --- A group through a long step

// Whether all bodies are where pairs were looked for.
bool staysInBoxes(const WorldState& state, const Group& group) {
  for (const Index index : group.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    for (const Index shapeIndex : body.shapes) {
      const ShapeSlot& shape = state.shapes[at(shapeIndex)];
      if (!holds(shape.swept, boundsOf(shape.data->whole, poseOfShape(body, shape)))) return false;
    }
  }
  return true;
}

// Returns false if a body has left its box.
bool advanceGroup(WorldState& state, const Group& group, const Goal& goal, Real end) {
  Workspace& work = state.work;
  Real known = group.island == kNone ? 0 : state.islands[at(group.island)].subStep;
  Real step = known > 0 ? known : end;
  for (Real now = 0; now < end;) {
    // Crumbs at the end are not worth a step of their own.
    const Real rest = end - now;
    const bool last = step > 0.999 * rest;
    const Real to = last ? end : rest < 2 * step ? now + rest / 2 : now + step;
    const Outcome outcome = tryTime(state, group, goal, now, to);
    const bool forced = !outcome.accepted && to - now <= state.settings.shortestSubStep;
    if (outcome.accepted || forced) {
      if (forced) ++state.counters.triesForced;
      // A time that was short only because the end was near says little.
      step = outcome.accepted
                 ? std::max((to - now) * outcome.factor, outcome.factor >= 1 ? step : Real(0))
                 : step;
      now = to;
      if (!staysInBoxes(state, group)) return false;
    } else {
      ++state.counters.triesRefused;
      step = std::max((to - now) * outcome.factor, state.settings.shortestSubStep / 2);
      putBack(state, group, work.tryBodies.data(), work.tryPairs.data());
    }
  }
  if (group.island != kNone) state.islands[at(group.island)].subStep = step;
  return true;
}

bool advanceFree(WorldState& state, const Goal& goal, Real end) {
  for (std::size_t i = 0; i < state.awakeBodies.size(); ++i) {
    const Index index = state.awakeBodies[i];
    BodySlot& body = state.bodies[at(index)];
    if (body.island != kNone) continue;
    body.isFree = true;
    body.acceleration = freeAcceleration(state, body);
    ++state.counters.bodiesFree;
    if (isExact(state, body) || !isDynamic(body)) {
      moveBody(state, index, end, true);
    } else {
      const std::array<Index, 1> self{index};
      advanceGroup(state, {kNone, self, {}}, goal, end);
    }
  }
  return true;
}

// --- Long steps

// Pairs of bodies that move both.
std::size_t movingPairs(const WorldState& state) {
  std::size_t count = 0;
  for (const Index index : state.awakePairs) {
    const PairSlot& pair = state.pairs[at(index)];
    count += isDynamic(state.bodies[at(pair.bodyA)]) && isDynamic(state.bodies[at(pair.bodyB)]);
  }
  return count;
}

// Finds the pairs of a long step; it is cut while there are too many of them.
// Returns its length.
Real findPairsFor(WorldState& state, Real length) {
  constexpr std::size_t kMany = 4, kFew = 16;  // pairs for each body, and in any case
  for (;;) {
    updatePairs(state, length);
    const std::size_t pairs = movingPairs(state);
    if (length <= kUsualStep || pairs <= kMany * state.awakeBodies.size() + kFew) return length;
    length = std::max(length / 2, kUsualStep);
  }
}

Group groupOf(const WorldState& state, Index island) {
  const IslandSlot& slot = state.islands[at(island)];
  return {island, slot.bodies, slot.pairs};
}

// Goes a long step. Returns its length: it may have been cut.
Real goLong(WorldState& state, Goal goal, Real length) {
  Workspace& work = state.work;
  length = findPairsFor(state, length);
  updateManifolds(state, length);
  splitIslands(state);
  countBodies(state);
  const std::size_t impacts = state.impacts.size();
  work.macroBodies.clear();
  work.macroPairs.clear();
  for (const Index island : state.awakeIslands) {
    keep(state, groupOf(state, island), work.macroBodies, work.macroPairs);
  }
  for (;;) {
    ++state.counters.macroSteps;
    bool inside = true;
    for (std::size_t i = 0; i < state.awakeIslands.size() && inside; ++i) {
      inside = advanceGroup(state, groupOf(state, state.awakeIslands[i]), goal, length);
    }
    if (inside || length <= state.settings.shortestSubStep) break;
    ++state.counters.macroStepsCut;
    state.impacts.resize(impacts);
    const SavedBody* bodies = work.macroBodies.data();
    const PairSlot* pairs = work.macroPairs.data();
    for (const Index island : state.awakeIslands) {
      const Group group = groupOf(state, island);
      putBack(state, group, bodies, pairs);
      bodies += group.bodies.size();
      pairs += group.pairs.size();
    }
    length /= 2;
  }
  // Kinematic bodies last: islands ask where they are at any time of the step.
  advanceFree(state, goal, length);
  for (std::size_t i = impacts; i < state.impacts.size(); ++i) {
    state.impacts[i].time += goal.duration - goal.left;
  }
  reportContacts(state);
  sleepIslands(state, length);
  return length;
}

// What of the settings a tolerance changes, for as long as it holds.
class Sharpened {
 public:
  Sharpened(WorldState& state, Real tolerance)
      : state_(state), touch_(state.settings.touchTolerance), still_(state.settings.keepStill) {
    // Here an island that does not change goes in one step as long as the long one anyway.
    state.settings.keepStill = false;
    for (const Index island : state.awakeIslands) state.islands[at(island)].still = false;
    state.settings.touchTolerance = std::min(touch_, tolerance / 16);
    const Real gravity = state.settings.gravity.norm();
    // A bounce at this speed rises a quarter of the tolerance. Below it steps must not have
    // impacts, either: what their ends are off by would be one in some tries and none in others.
    state.slowestBounce = std::sqrt(gravity * tolerance / 2) + 1e-12;
    state.slowestImpact = state.slowestBounce;
    state.longSteps = true;
  }
  ~Sharpened() {
    state_.settings.touchTolerance = touch_;
    state_.settings.keepStill = still_;
    state_.longSteps = false;
  }
  Sharpened(const Sharpened&) = delete;
  Sharpened& operator=(const Sharpened&) = delete;

 private:
  WorldState& state_;
  Real touch_;
  bool still_;
};

}  // namespace

void advanceWorld(WorldState& state, Real duration, Real tolerance) {
  beginStep(state, std::min(duration, kUsualStep));
  const Sharpened sharpened(state, tolerance);
  Real next = state.macroStep > 0 ? state.macroStep : duration;
  for (Real done = 0; done < duration;) {
    const Real left = duration - done;
    // Who may fall asleep is looked at twice in the time that it takes.
    const bool sleepy = state.settings.sleeping && !state.awakeIslands.empty();
    Real length = std::min(next, sleepy ? state.settings.sleepTime / 2 : left);
    if (length > 0.999 * left) length = left;
    const Real gone = goLong(state, {tolerance, duration, left}, length);
    // Cut in two, or to its end; after that twice as long is tried.
    next = gone < length ? gone : 2 * gone;
    done = gone >= left ? duration : done + gone;
  }
  state.macroStep = next;
  addCarefully(state.time, state.lostTime, duration);
}

}  // namespace carom::world
