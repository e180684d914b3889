#include "carom/world/advance_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/detection/bounds.hpp"
#include "carom/motion/careful_sum.hpp"
#include "carom/motion/step_controller.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/world/advance_island.hpp"
#include "carom/world/crowd.hpp"
#include "carom/world/islands.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/step_world.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

constexpr int kMostTries = 8;          // of one time, in 1, 2, ... steps
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

// A body as it is, but for its anchor.
SavedBody saved(const BodySlot& body) {
  return {body.position, body.lost, body.orientation, body.velocity, body.clock, {}};
}

void keep(const WorldState& state, const Group& group, std::vector<SavedBody>& bodies,
          std::vector<PairSlot>& pairs) {
  for (const Index index : group.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    bodies.push_back(saved(body));
    if (body.anchor) bodies.back().anchor = state.anchors[*body.anchor];
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
    body.lost = saved.lost;
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
  for (const Index index : group.bodies) ends.push_back(saved(state.bodies[at(index)]));
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

// How wrong something is, and how much of it is more than rounding makes [m].
struct Wrong {
  Real whole = 0, beyond = 0;
};

// How wrong a difference makes a body at the end.
Wrong sizeOf(const Difference& d, const BodySlot& body, const SavedBody& end, Real ahead) {
  constexpr Real kRoundings = 64 * std::numeric_limits<Real>::epsilon();
  const Real fast = end.velocity.linear.norm() + end.velocity.angular.norm();
  const Real noise =
      kRoundings * (end.position.cwiseAbs().maxCoeff() + body.reach + 1 + ahead * fast);
  const Real way = d.way.norm() + ahead * d.velocity.linear.norm();
  const Real turn = d.turn.norm() + ahead * d.velocity.angular.norm();
  const Real whole = std::max(way, turn);
  return {whole, std::max(Real(0), whole - noise)};
}

// Weights of the ends of 1, 2, ..., m steps. They add up to one and take away what goes with the
// second to the m-th power of the step: an island's steps are of second order and not symmetric, so
// that odd powers are there as well (extrapolation.hpp has even ones alone). It is the polynomial
// through the ends whose slope at zero is zero.
constexpr std::array<Real, kMostTries> weightsOf(int count) {
  std::array<Real, kMostTries> weights = {};
  for (int k = 1; k <= count; ++k) {
    Real above = 2 * k, below = count * (count + 1);
    for (int j = 1; j <= count; ++j) {
      if (j == k) continue;
      above *= k;
      below *= k - j;
    }
    weights[at(k - 1)] = above / below;
  }
  return weights;
}

constexpr std::array<std::array<Real, kMostTries>, kMostTries> kWeights = [] {
  std::array<std::array<Real, kMostTries>, kMostTries> all = {};
  for (int count = 1; count <= kMostTries; ++count) all[at(count - 1)] = weightsOf(count);
  return all;
}();

// Steps that the first `count` tries take together.
constexpr Real costOf(int count) {
  return count * (count + 1) / 2;
}

// What the first `count` tries tend to for steps of no length, seen from the last of them.
Difference tendency(const std::vector<SavedBody>& ends, std::size_t bodies, std::size_t body,
                    int count) {
  const std::array<Real, kMostTries>& weights = kWeights[at(count - 1)];
  const SavedBody& last = ends[at(count - 1) * bodies + body];
  Difference sum;
  for (int k = 0; k + 1 < count; ++k)
    addTimes(sum, weights[at(k)], last, ends[at(k) * bodies + body]);
  return sum;
}

// The error of the answer of the first `count` tries: by how much the last of them changed it.
Wrong errorOf(const WorldState& state, const Group& group, int count, bool smooth, Real ahead) {
  const std::vector<SavedBody>& ends = state.work.ends;
  const std::size_t n = group.bodies.size();
  Wrong worst;
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
    const Wrong one = sizeOf(change, state.bodies[at(group.bodies[i])], last, ahead);
    worst = {std::max(worst.whole, one.whole), std::max(worst.beyond, one.beyond)};
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

// What is known of a time before it is tried.
struct Span {
  Real start = 0, end = 0;     // [s]
  Real last = 0;               // end of the long step [s]
  bool refusedBefore = false;  // a longer one has just been refused
};

// Judges the error of a try that went in `order` pieces at most, and says how to go on.
StepChoice choose(const Goal& goal, const Span& span, Real error, int order) {
  constexpr Real kSafety = 0.25;
  return stepController({.length = span.end - span.start,
                         .left = span.last - span.start,
                         .duration = goal.duration,
                         .error = error,
                         .tolerance = kSafety * goal.tolerance,
                         .order = order,
                         .refusedBefore = span.refusedBefore});
}

// The same, where rounding is no reason to refuse a try. Nor is it one to go much farther.
StepChoice choose(const Goal& goal, const Span& span, const Wrong& wrong, int order) {
  const StepChoice all = choose(goal, span, wrong.whole, order);
  if (all.accepted) return all;
  StepChoice beyond = choose(goal, span, wrong.beyond, order);
  if (!beyond.accepted) return all;
  beyond.wanted = std::min(beyond.wanted, 2 * (span.end - span.start));
  beyond.next = std::min(beyond.next, beyond.wanted);
  return beyond;
}

// Tries one time in one step, in two and so on, until the error is small enough or it is clear that
// it will not be. Of what was tried, and of one try more, that way is chosen for the next time
// which costs least for the time that it covers.
StepChoice tryTime(WorldState& state, const Group& group, const Goal& goal, const Span& span) {
  Workspace& work = state.work;
  const Real length = span.end - span.start;
  const Real ahead = std::max(Real(1), goal.left - span.end);
  const std::size_t impacts = state.impacts.size();
  const int hardFor = group.island == kNone ? 0 : state.islands[at(group.island)].hardFor;
  work.tryBodies.clear();
  work.tryPairs.clear();
  work.ends.clear();
  keep(state, group, work.tryBodies, work.tryPairs);

  const std::int64_t rows = state.counters.normalRows;
  IslandRun run = goInSteps(state, group, span.start, span.end, 1);
  // A pile goes its usual steps: nobody asks where each of its bodies comes to lie.
  if (run.isPile) {
    const bool fits = length <= kUsualStep;
    const Real left = span.last - (fits ? span.end : span.start);
    return {fits, kUsualStep, std::min(kUsualStep, left)};
  }
  bool exact = run.byEvents && state.counters.normalRows == rows;
  for (const Index body : group.bodies) exact = exact && isExact(state, state.bodies[at(body)]);
  if (exact) return choose(goal, span, 0, 1);

  noteEnd(state, group, work.ends);
  bool smooth = state.settings.extrapolation && run.byEvents && run.events == 0;
  StepChoice best;
  Real bestCost = std::numeric_limits<Real>::infinity();
  const auto take = [&](const StepChoice& choice, int count) {
    const Real cost = costOf(count) / choice.wanted;
    if (cost < bestCost) {
      best = choice;
      bestCost = cost;
    }
  };
  Real before = std::numeric_limits<Real>::infinity();
  bool accepted = false;
  for (int count = 2; count <= kMostTries; ++count) {
    putBack(state, group, work.tryBodies.data(), work.tryPairs.data());
    if (group.island != kNone) state.islands[at(group.island)].hardFor = hardFor;
    state.impacts.resize(impacts);
    run = goInSteps(state, group, span.start, span.end, count);
    noteEnd(state, group, work.ends);
    smooth = smooth && run.byEvents && run.events == 0;
    const Wrong error = errorOf(state, group, count, smooth, ahead);
    if (!smooth) {
      // What happens on the way gets a share of its own, however short the time around it.
      constexpr Real kShare = 1.0 / 32;
      const Real part = length / goal.duration;
      return choose(goal, span, error.beyond * std::min(Real(1), part / kShare), 2);
    }
    const StepChoice choice = choose(goal, span, error, count);
    take(choice, count);
    accepted = choice.accepted;
    if (accepted) takeAnswer(state, group, count);
    // One try more would gain about as much as this one did.
    constexpr Real kUsualGain = 0.1;
    if (accepted && count < kMostTries) {
      const Real gain = std::max(kUsualGain, std::min(Real(1), error.whole / before));
      take(choose(goal, span, error.whole * gain, count + 1), count + 1);
    }
    // All that are left would not gain enough. The first two say little about that.
    Real hoped = error.beyond;
    for (int left = count; left < kMostTries; ++left) hoped *= kUsualGain;
    const bool hopeless = count > 2 && !choose(goal, span, hoped, count).accepted;
    if (accepted || hopeless || error.whole > before / 2) break;
    before = error.whole;
  }
  best.accepted = accepted;
  if (accepted) return best;
  // Nothing was good enough, and no time has gone by.
  best.wanted = std::min(best.wanted, Real(0.9) * length);
  return best;
}

// --- A group through a long step

// Whether all bodies are where pairs were looked for.
bool staysInBoxes(const WorldState& state, const Group& group) {
  for (const Index index : group.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    for (const Index shapeIndex : body.shapes) {
      const ShapeSlot& shape = state.shapes[at(shapeIndex)];
      if (!holds(shape.swept, boundsOfShape(shape, poseOfShape(body, shape)))) return false;
    }
  }
  return true;
}

// Returns false if a body has left its box.
bool advanceGroup(WorldState& state, const Group& group, const Goal& goal, Real end) {
  Workspace& work = state.work;
  const Real known = group.island == kNone ? 0 : state.islands[at(group.island)].subStep;
  Real wanted = known > 0 ? known : end;
  Real step = std::min(wanted, end);
  bool refused = false;
  for (Real now = 0; now < end;) {
    // Crumbs at the end are not worth a step of their own.
    const Real to = step > 0.999 * (end - now) ? end : now + step;
    const StepChoice choice = tryTime(state, group, goal, {now, to, end, refused});
    const bool forced = !choice.accepted && to - now <= state.settings.shortestSubStep;
    if (choice.accepted || forced) {
      if (forced) ++state.counters.triesForced;
      // A time that was short only because the end was near says little.
      const bool cut = to - now < 0.999 * wanted;
      if (choice.accepted) wanted = cut ? std::max(wanted, choice.wanted) : choice.wanted;
      step = std::max(forced ? to - now : choice.next, Real(0));
      now = to;
      refused = false;
      if (!staysInBoxes(state, group)) return false;
    } else {
      ++state.counters.triesRefused;
      refused = true;
      step = wanted = std::max(choice.wanted, state.settings.shortestSubStep / 2);
      putBack(state, group, work.tryBodies.data(), work.tryPairs.data());
    }
  }
  if (group.island != kNone) state.islands[at(group.island)].subStep = wanted;
  return true;
}

void advanceFree(WorldState& state, const Goal& goal, Real end) {
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
  state.partStart = goal.duration - goal.left;
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
  reportContacts(state);
  sleepIslands(state, length);
  return length;
}

// What of the settings a tolerance changes, for as long as it holds.
class Sharpened {
 public:
  Sharpened(WorldState& state, Real duration, Real tolerance)
      : state_(state), touch_(state.settings.touchTolerance), still_(state.settings.keepStill) {
    // Here an island that does not change goes in one step as long as the long one anyway.
    state.settings.keepStill = false;
    for (const Index island : state.awakeIslands) state.islands[at(island)].still = false;
    state.settings.touchTolerance = std::min(touch_, tolerance / 16);
    const Real gravity = state.settings.gravity.norm();
    // A bounce at this speed rises a quarter of the tolerance. Below it steps must not have
    // impacts, either: what their ends are off by would be one in some tries and none in others.
    state.slowestBounce = std::sqrt(gravity * tolerance / 2) + 1e-12;
    // What approaches more slowly than that is stopped over a step, and sinks in on the way: by half
    // of the tolerance if one step goes all the way. Usual steps make no impacts of less, either.
    const Real slow = std::max(tolerance / duration, state.slowestImpact);
    state.slowestImpact = std::min(state.slowestBounce, slow);
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
  const Sharpened sharpened(state, duration, tolerance);
  Real next = state.macroStep > 0 ? state.macroStep : duration;
  for (Real done = 0; done < duration;) {
    const Real left = duration - done;
    // Who may fall asleep is looked at twice in the time that it takes.
    const bool sleepy = state.settings.sleeping && !state.awakeIslands.empty();
    Real length = std::min(next, sleepy ? state.settings.sleepTime / 2 : left);
    if (length > 0.999 * left) length = left;
    length /= partsForCrowd(state, length);
    const Real gone = goLong(state, {tolerance, duration, left}, length);
    // Cut in two, or to its end; after that twice as long is tried.
    next = gone < length ? gone : 2 * gone;
    done = gone >= left ? duration : done + gone;
  }
  state.macroStep = next;
  addCarefully(state.time, state.lostTime, duration);
}

}  // namespace carom::world
