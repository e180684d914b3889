#include "carom/world/update_contacts.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "carom/detection/bounds.hpp"
#include "carom/manifold/collide.hpp"
#include "carom/manifold/collide_half_space.hpp"
#include "carom/manifold/collide_hulls.hpp"
#include "carom/manifold/swap_manifold.hpp"
#include "carom/world/collide_ground.hpp"
#include "carom/world/islands.hpp"
#include "carom/world/leave_ground.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/quiet.hpp"

namespace carom::world {

namespace {

// Fewer than these are not worth a second thread.
constexpr std::size_t kFewBodies = 64, kFewPairs = 128;

// How far the points of a body can go in a time, in any direction: by its speed and by what acts on
// it, and by its turning.
struct Ways {
  Real straight = 0, round = 0;  // [m]
};

Ways waysOf(const WorldState& state, const BodySlot& body, Real duration) {
  if (body.asleep || body.kind == BodyKind::immovable) return {};
  const Real turn = body.velocity.angular.norm() * duration;
  return {body.velocity.linear.norm() * duration +
              freeAcceleration(state, body).norm() * duration * duration / 2,
          body.reach * std::min(turn, Real(2))};
}

void beginPair(WorldState& state, Index index, const IndexPair& shapes) {
  if (at(index) >= state.pairs.size()) {
    state.pairs.resize(at(index) + 1);
    state.kept.resize(at(index) + 1);
    makeRoomForLists(state, state.bodies.capacity(), state.pairs.capacity());
  }
  state.kept[at(index)].known = false;
  PairSlot& pair = state.pairs[at(index)];
  pair = PairSlot();
  pair.alive = true;
  const ShapeSlot *a = &state.shapes[at(shapes.first)], *b = &state.shapes[at(shapes.second)];
  pair.shapeA = shapes.first;
  pair.shapeB = shapes.second;
  // What cannot be moved is A, whoever was added first.
  if (isDynamic(state.bodies[at(a->body)]) && !isDynamic(state.bodies[at(b->body)])) {
    std::swap(a, b);
    std::swap(pair.shapeA, pair.shapeB);
  }
  pair.bodyA = a->body;
  pair.bodyB = b->body;
  pair.order = orderOf(state, pair);
  const Real frictions = a->material.friction * b->material.friction;
  if (state.settings.friction) pair.friction = std::sqrt(frictions);
  if (state.settings.restitution) {
    pair.restitution = combineRestitution(a->material.restitution, b->material.restitution,
                                          state.settings.restitutionRule);
  }
  ++state.counters.pairsBegun;
  listPair(state, index);
}

// The forces of the last manifold, for the points that are still there: they have the same names,
// or, where faces lie on each other and either may give the names, the same places.
void handOn(const Manifold& old, const std::array<Real, 4>& forces, Real near, PairSlot& pair) {
  pair.force = {};
  std::array<bool, 4> taken = {}, found = {};
  const auto take = [&](int i, int j) {
    pair.force[at(i)] = forces[at(j)];
    found[at(i)] = taken[at(j)] = true;
  };
  for (int i = 0; i < pair.manifold.count; ++i) {
    for (int j = 0; j < old.count; ++j) {
      if (!taken[at(j)] && old.points[at(j)].id == pair.manifold.points[at(i)].id) {
        take(i, j);
        break;
      }
    }
  }
  for (int i = 0; i < pair.manifold.count; ++i) {
    for (int j = 0; j < old.count && !found[at(i)]; ++j) {
      const Vector3 way = pair.manifold.points[at(i)].position - old.points[at(j)].position;
      if (!taken[at(j)] && way.norm() <= near) take(i, j);
    }
  }
}

}  // namespace

void makeRoomForLists(WorldState& state, std::size_t bodies, std::size_t pairs) {
  Workspace& work = state.work;
  Pile& pile = state.pile;
  for (std::vector<Index>* list : {&work.set, &pile.members}) list->reserve(bodies);
  for (std::vector<Index>* list :
       {&state.awakePairs, &work.toMake, &work.innerPairs, &pile.pairs}) {
    list->reserve(pairs);
  }
  work.setPairs.reserve(2 * pairs);  // a pair may be there for each of its bodies
  for (std::vector<ContactEvent>* list : {&state.begun, &state.ended}) list->reserve(pairs);
  work.links.reserve(pairs);
  pile.looks.reserve(pairs);
  pile.edges.reserve(pairs);
  pile.counts.reserve(pairs);
  // Each pair with what cannot be moved gives it a number.
  work.labels.reserve(bodies + pairs);
  work.flags.reserve(bodies + pairs);
  work.seen.reserve(std::max(bodies, pairs));
}

bool mayMeet(const WorldState& state, Index a, Index b) {
  const ShapeSlot &p = state.shapes[at(a)], &q = state.shapes[at(b)];
  if (p.body == q.body) return false;
  if (!isDynamic(state.bodies[at(p.body)]) && !isDynamic(state.bodies[at(q.body)])) return false;
  if (p.filter.family != 0 && p.filter.family == q.filter.family) return false;
  return (p.filter.mask & q.filter.group) != 0 && (q.filter.mask & p.filter.group) != 0;
}

Aabb<3> boundsOfShape(const ShapeSlot& shape, const Pose& pose) {
  const ShapeData& data = *shape.data;
  if (data.ground) return boundsOfItem(*data.ground, shape.item, pose);
  // Of a hull the copy that manifolds read.
  return data.isHalfSpace ? boundsOf(data.whole, pose) : boundsOf(data.convex, pose);
}

namespace {

// Nothing but the body and its shapes is changed: several threads do this at the same time.
void sweepBoxes(WorldState& state, Index index, Real dt) {
  BodySlot& body = state.bodies[at(index)];
  const Ways ways = waysOf(state, body, dt);
  body.straight = ways.straight;
  body.round = ways.round;
  for (const Index shapeIndex : body.shapes) {
    ShapeSlot& shape = state.shapes[at(shapeIndex)];
    const Real round = isCentredBall(shape) ? 0 : ways.round;
    const Real way = std::max(ways.straight + round, body.struck);
    const Vector3 room =
        Vector3::Constant(way + state.settings.touchTolerance + state.settings.restTolerance);
    shape.swept = boundsOfShape(shape, poseOfShape(body, shape));
    shape.swept.low -= room;
    shape.swept.high += room;
  }
}

// The box by which pairs of a shape are found.
Aabb<3> boxForPairs(const WorldState& state, Index shape) {
  if (state.settings.pairFinding != PairFinding::allPairs) return state.shapes[at(shape)].swept;
  const Vector3 everywhere = Vector3::Constant(std::numeric_limits<Real>::infinity());
  return {-everywhere, everywhere};
}

void tellBoxes(WorldState& state, Index index, Real dt) {
  const BodySlot& body = state.bodies[at(index)];
  for (const Index shape : body.shapes) {
    state.broadPhase.move(shape, boxForPairs(state, shape), dt * body.velocity.linear);
  }
}

}  // namespace

void moveBoxes(WorldState& state, Index index, Real dt) {
  sweepBoxes(state, index, dt);
  tellBoxes(state, index, dt);
}

void endPair(WorldState& state, Index index) {
  PairSlot& pair = state.pairs[at(index)];
  if (!pair.alive) return;
  ++state.counters.pairsEnded;
  if (pair.touches) state.ended.push_back(eventOf(state, pair));
  if (pair.island != kNone) releasePair(state, index);
  pair.alive = false;
  listPair(state, index);
}

ContactEvent eventOf(const WorldState& state, const PairSlot& pair) {
  return {idOfShape(state, pair.shapeA), idOfShape(state, pair.shapeB), idOfBody(state, pair.bodyA),
          idOfBody(state, pair.bodyB)};
}

namespace {

void findPairs(WorldState& state) {
  const std::int64_t before = state.broadPhase.counters().tested;
  state.broadPhase.update([&](Index a, Index b) { return mayMeet(state, a, b); },
                          &threadsOf(state.pile, state.settings.threads));
  state.counters.pairsTested += state.broadPhase.counters().tested - before;
  for (const BroadPhase::Event& event : state.broadPhase.ended()) endPair(state, event.slot);
  for (const BroadPhase::Event& event : state.broadPhase.begun()) {
    beginPair(state, event.slot, event.pair);
  }
}

// How far a body comes at most in this step, whatever strikes it.
Real farthest(const BodySlot& body) {
  return std::max(body.way, body.struck);
}

// Whether two bodies stay apart in a step, however they turn: who is not struck goes straight on,
// who may be, any way. What is nearest of the way of one, as the other sees it.
bool passEachOther(const WorldState& state, const PairSlot& pair, Real dt) {
  const BodySlot &a = state.bodies[at(pair.bodyA)], &b = state.bodies[at(pair.bodyB)];
  if (!isDynamic(a)) return false;  // walls and grounds are as wide as they like
  // What pulls or carries a body turns it aside, too; and what touches may be apart by a little.
  const Real pull = freeAcceleration(state, a).norm() + freeAcceleration(state, b).norm();
  const Real margin = state.settings.contactMargin + state.settings.restTolerance;
  Real near = a.reach + b.reach + margin + pull * dt * dt;
  Vector3 speed = Vector3::Zero();
  const auto goes = [&](const BodySlot& body, Real sign) {
    if (body.mayTurn) {
      near += farthest(body);
    } else {
      speed += sign * body.velocity.linear;
    }
  };
  goes(a, -1);
  goes(b, 1);
  const Vector3 apart = b.position - a.position;
  const Real approach = -apart.dot(speed);
  const Real when = approach > 0 ? std::min(approach / speed.squaredNorm(), dt) : 0;
  return (apart + when * speed).squaredNorm() > near * near;
}

// Whether the points of a pair are of interest in this step. Where nobody asks who is struck, and
// in a pile, where contacts push without a blow, boxes that meet are all that is known.
bool mayTouch(const WorldState& state, const PairSlot& pair, Real dt) {
  if (!meets(state.shapes[at(pair.shapeA)].swept, state.shapes[at(pair.shapeB)].swept)) {
    return false;
  }
  if (!state.settings.locateEvents || isOfPile(state, state.bodies[at(pair.bodyA)]) ||
      isOfPile(state, state.bodies[at(pair.bodyB)])) {
    return true;
  }
  return !passEachOther(state, pair, dt);
}

// How far a body of a pair can push what it strikes: by its way, and by its turning.
Real farthestPush(const WorldState& state, Index index, Index shape) {
  const BodySlot& body = state.bodies[at(index)];
  return farthest(body) + (isCentredBall(state.shapes[at(shape)]) ? 0 : body.round);
}

// Gives a body the room that it needs if another strikes it. Returns whether it had less.
bool makeRoom(WorldState& state, const PairSlot& pair, Index striking, Real push, Index struck,
              Real dt) {
  const BodySlot& fast = state.bodies[at(striking)];
  BodySlot& slow = state.bodies[at(struck)];
  if (!isDynamic(slow) || slow.asleep || fast.kind == BodyKind::immovable) return false;
  // In a pile blows go from step to step.
  if (isOfPile(state, slow)) return false;
  // As fast as a blow in the middle makes what stood; and no farther than a few neighbours, unless
  // the step is a long one, in which nobody asks again.
  const Real parts = isDynamic(fast) ? fast.weight / (fast.weight + slow.weight) : 1;
  const Real blow = (1 + pair.restitution) * parts * (fast.asleep ? 0 : push);
  const Real thrown = state.longSteps ? blow : std::min(blow, 2 * slow.reach);
  const Real room = farthest(slow);
  if (thrown <= room + state.settings.restTolerance) return false;
  slow.struck = thrown;
  slow.kept = false;
  moveBoxes(state, struck, dt);
  return true;
}

// Whether nothing about a body has changed since the last step, its boxes included. What is placed
// anew between steps wakes those it meets, which are not kept then.
bool isKept(const BodySlot& body) {
  return body.kept || body.asleep || body.kind == BodyKind::immovable;
}

bool isKept(const WorldState& state, const PairSlot& pair) {
  return pair.known && isKept(state.bodies[at(pair.bodyA)]) && isKept(state.bodies[at(pair.bodyB)]);
}

// Whether a blow between the bodies of a pair may ask for room.
bool mayStrike(const WorldState& state, const PairSlot& pair, Real dt) {
  if (isOfPile(state, pair)) return false;
  if (isKept(state, pair)) return false;
  if (!meets(state.shapes[at(pair.shapeA)].swept, state.shapes[at(pair.shapeB)].swept)) {
    return false;
  }
  // What is slow throws nobody out of his room.
  const Real pushes =
      farthestPush(state, pair.bodyA, pair.shapeA) + farthestPush(state, pair.bodyB, pair.shapeB);
  return 2 * pushes > state.settings.restTolerance && !passEachOther(state, pair, dt);
}

// What a pair that may strike gives room to, and what it may turn aside: these bodies are listed.
// Returns whether one got more room.
bool makeRoomIn(WorldState& state, const PairSlot& pair, Real dt) {
  BodySlot &a = state.bodies[at(pair.bodyA)], &b = state.bodies[at(pair.bodyB)];
  const Real pushA = farthestPush(state, pair.bodyA, pair.shapeA);
  const Real pushB = farthestPush(state, pair.bodyB, pair.shapeB);
  const bool roomA = makeRoom(state, pair, pair.bodyB, pushB, pair.bodyA, dt);
  const bool roomB = makeRoom(state, pair, pair.bodyA, pushA, pair.bodyB, dt);
  const auto note = [&](BodySlot& body, Index index, bool room) {
    if (!isDynamic(body) || body.asleep || (body.mayTurn && !room)) return;
    body.mayTurn = true;
    state.work.set.push_back(index);
  };
  note(a, pair.bodyA, roomA);
  note(b, pair.bodyB, roomB);
  return roomA || roomB;
}

// The awake pairs in their order. Who may strike as things stand is found by all threads at once;
// a body that is given room, or turned aside, lets its other pairs be asked again.
bool makeFirstRooms(WorldState& state, Real dt) {
  Workspace& work = state.work;
  const std::span<const Index> awake = state.awakePairs;
  work.seen.resize(awake.size());
  shareOut(state, awake.size(), kFewPairs, [&](std::size_t i) {
    fetchAhead(state, awake, i);
    work.seen[i] = mayStrike(state, state.pairs[at(awake[i])], dt) ? 1 : 0;
  });
  bool any = false;
  for (std::size_t i = 0; i < awake.size(); ++i) {
    if (work.seen[i] == 0) continue;
    const PairSlot& pair = state.pairs[at(awake[i])];
    if (work.seen[i] == 2 && !mayStrike(state, pair, dt)) continue;
    const std::size_t before = work.set.size();
    any |= makeRoomIn(state, pair, dt);
    for (std::size_t k = before; k < work.set.size(); ++k) {
      for (const Index shape : state.bodies[at(work.set[k])].shapes) {
        state.broadPhase.pairs().forEachOf(shape, [&](std::int32_t other, std::int32_t) {
          work.seen[at(state.pairs[at(other)].awakeAt)] = 2;
        });
      }
    }
  }
  return any;
}

// Blows go on through the pairs that there are, from those in the list on. Returns whether a body
// got more room.
bool makeRooms(WorldState& state, std::span<const Index> first, Real dt) {
  Workspace& work = state.work;
  work.set.clear();
  bool any = false;
  const auto look = [&](Index index) {
    const PairSlot& pair = state.pairs[at(index)];
    if (mayStrike(state, pair, dt)) any |= makeRoomIn(state, pair, dt);
  };
  if (first.data() == state.awakePairs.data() && state.settings.threads > 1) {
    any = makeFirstRooms(state, dt);
  } else {
    for (const Index pair : first) look(pair);
  }
  // Only who was struck can hand it on.
  constexpr int kMost = 8;
  for (int round = 0; round < kMost && !work.set.empty(); ++round) {
    work.setPairs.clear();
    for (const Index body : work.set) {
      for (const Index shape : state.bodies[at(body)].shapes) {
        state.broadPhase.pairs().forEachOf(
            shape, [&](std::int32_t pair, std::int32_t) { work.setPairs.push_back(pair); });
      }
    }
    work.set.clear();
    for (const Index pair : work.setPairs) look(pair);
  }
  return any;
}

// Where a body may be in a step that begins. Returns whether the broad phase has to be told.
bool beginBody(WorldState& state, Index index, Real dt) {
  BodySlot& body = state.bodies[at(index)];
  body.clock = 0;
  body.mayTurn = false;
  body.kept = body.struck == 0 && body.island != kNone && state.islands[at(body.island)].still;
  if (body.kept) return false;
  body.struck = 0;
  body.way = body.velocity.linear.norm() * dt;
  sweepBoxes(state, index, dt);
  return !std::all_of(body.shapes.begin(), body.shapes.end(), [&](Index shape) {
    return state.broadPhase.staysIn(shape, boxForPairs(state, shape), dt * body.velocity.linear);
  });
}

}  // namespace

void updatePairs(WorldState& state, Real dt) {
  Workspace& work = state.work;
  const std::span<const Index> awake = state.awakeBodies;
  work.seen.resize(awake.size());
  shareOut(state, awake.size(), kFewBodies,
           [&](std::size_t i) { work.seen[i] = beginBody(state, awake[i], dt) ? 1 : 0; });
  for (std::size_t i = 0; i < awake.size(); ++i) {
    if (work.seen[i] != 0) tellBoxes(state, awake[i], dt);
  }
  // What is struck may meet others that it would not have come near by itself; and these, others.
  // The pairs of the last step know most of it: then pairs are looked for once.
  const bool strikes = state.settings.locateEvents;
  if (strikes) makeRooms(state, state.awakePairs, dt);
  findPairs(state);
  constexpr int kMost = 8;
  for (int round = 0; strikes && round < kMost; ++round) {
    work.innerPairs.clear();
    for (const BroadPhase::Event& begun : state.broadPhase.begun()) {
      work.innerPairs.push_back(begun.slot);
    }
    if (!makeRooms(state, work.innerPairs, dt)) break;
    findPairs(state);
  }
}

namespace {

// Share of the contact margin that bodies of a pile may move against each other before their
// manifold is made anew: a millimetre.
constexpr Real kKeptWay = 0.1;
// And share of it that hulls of a pile may move against each other, and sink or rise, before their
// nearest features are looked for anew: a centimetre, and three millimetres.
constexpr Real kStrayedWay = 1, kStrayedDepth = 0.3;

// How far apart a pair's points are of interest, by how far its two bodies can go.
Real marginOf(const WorldState& state, const PairSlot& pair, const Ways& a, const Ways& b) {
  const auto way = [&](const Ways& ways, Index shape) {
    return ways.straight + (isCentredBall(state.shapes[at(shape)]) ? 0 : ways.round);
  };
  return state.settings.contactMargin + way(a, pair.shapeA) + way(b, pair.shapeB);
}

// Whether a pair's manifold comes from a search for separating axes.
bool searchesAxes(const WorldState& state, const PairSlot& pair) {
  return state.shapes[at(pair.shapeA)].data->usesAxes &&
         state.shapes[at(pair.shapeB)].data->usesAxes;
}

// Whether a pair's manifold may be carried along: one is a hull, the other has corners or is a plane.
// Those of boxes are made as fast as carried, and walls of boxes stand better by new ones.
bool mayBeCarried(const WorldState& state, const PairSlot& pair) {
  const ShapeData &a = *state.shapes[at(pair.shapeA)].data,
                  &b = *state.shapes[at(pair.shapeB)].data;
  const auto isHull = [](const ShapeData& shape) {
    return shape.usesAxes && std::holds_alternative<ConvexHull>(shape.convex);
  };
  if (!isHull(a) && !isHull(b)) return false;
  return (a.usesAxes || a.isHalfSpace) && (b.usesAxes || b.isHalfSpace);
}

// The manifold for shapes at these poses. Nothing but the pair is changed: several threads do this
// at the same time.
void collidePair(const WorldState& state, PairSlot& pair, const Pose& A, const Pose& B,
                 Real margin) {
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const Manifold old = pair.manifold;
  const std::array<Real, 4> forces = pair.force;
  if (a.data->ground) {
    pair.manifold = collideGround(*a.data->ground, a.item, A, b.data->convex, B, margin);
    leaveGround(state, pair, A);
  } else if (a.data->isHalfSpace) {
    pair.manifold =
        collideHalfSpace(std::get<HalfSpace>(a.data->whole), A, b.data->convex, B, margin);
  } else if (b.data->isHalfSpace) {
    pair.manifold =
        collideHalfSpace(std::get<HalfSpace>(b.data->whole), B, a.data->convex, A, margin);
    detail::swapBodies(pair.manifold);
  } else {
    pair.manifold = collide(a.data->convex, A, b.data->convex, B, &pair.cache, margin);
  }
  pair.carried = pair.narrow = pair.leftOut = false;
  handOn(old, forces, state.settings.contactMargin, pair);
}

void countManifold(const WorldState& state, const PairSlot& pair, Counters& counters) {
  counters.contactPoints += pair.manifold.count;
  if (pair.carried) {
    ++counters.manifoldsCarried;
    return;
  }
  ++counters.manifoldsMade;
  if (searchesAxes(state, pair)) ++counters.axesSearches;
}

// What one thread has counted is added to what the others have.
void addManifolds(const Counters& some, Counters& all) {
  const auto add = [](std::int64_t part, std::int64_t& sum) {
    std::atomic_ref<std::int64_t>(sum).fetch_add(part, std::memory_order_relaxed);
  };
  add(some.contactPoints, all.contactPoints);
  add(some.manifoldsCarried, all.manifoldsCarried);
  add(some.manifoldsMade, all.manifoldsMade);
  add(some.axesSearches, all.axesSearches);
}

Real deepestOf(const Manifold& manifold) {
  Real deepest = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < manifold.count; ++i) {
    deepest = std::min(deepest, manifold.points[at(i)].separation);
  }
  return deepest;
}

// Where two hulls have come to, and how far they moved against each other on the way.
struct HullWay {
  const Pose &A, &B;
  Real margin = 0, way = 0;  // [m]
};

// Makes the manifold of two hulls from the features that were the nearest ones when they were last
// looked for, if those hardly moved. Returns whether it did.
bool keepFeatures(const WorldState& state, PairSlot& pair, KeptManifold& kept,
                  const HullWay& went) {
  const Real strayed = kept.strayed + went.way;
  const Real most = kStrayedWay * state.settings.contactMargin;
  if (pair.manifold.count == 0 || strayed > most) return false;
  const auto* a = std::get_if<ConvexHull>(&state.shapes[at(pair.shapeA)].data->convex);
  const auto* b = std::get_if<ConvexHull>(&state.shapes[at(pair.shapeB)].data->convex);
  if (a == nullptr || b == nullptr || !searchesAxes(state, pair)) return false;
  const Manifold now = collideHullsOn(*a, went.A, *b, went.B, pair.cache, went.margin);
  if (now.count == 0) return false;
  const Real sunk = std::abs(deepestOf(now) - kept.deepest);
  if (sunk > kStrayedDepth * state.settings.contactMargin) return false;
  const Manifold old = pair.manifold;
  const std::array<Real, 4> forces = pair.force;
  pair.manifold = now;
  handOn(old, forces, state.settings.contactMargin, pair);
  pair.carried = true;
  const Real deepest = kept.deepest;
  kept = keptManifold(now, went.A, went.B, went.margin);
  kept.deepest = deepest;
  kept.strayed = strayed;
  return true;
}

// The manifold at the start of a step: made, or, within a pile, carried along.
void startManifold(WorldState& state, Index index) {
  PairSlot& pair = state.pairs[at(index)];
  const BodySlot &bodyA = state.bodies[at(pair.bodyA)], &bodyB = state.bodies[at(pair.bodyB)];
  const Pose A = poseOfShape(bodyA, state.shapes[at(pair.shapeA)]);
  const Pose B = poseOfShape(bodyB, state.shapes[at(pair.shapeB)]);
  // Boxes were made by the same ways.
  const Real most =
      marginOf(state, pair, {bodyA.straight, bodyA.round}, {bodyB.straight, bodyB.round});
  pair.madeAt = 0;
  KeptManifold& kept = state.kept[at(index)];
  const bool isSoft = isOfPile(state, pair);
  const Real margin =
      isSoft ? std::min(most, state.settings.contactMargin + quietReach(state, pair)) : most;
  if (!isSoft || !mayBeCarried(state, pair)) {
    collidePair(state, pair, A, B, margin);
    pair.narrow = margin < most;
    kept.known = false;
    return;
  }
  // A margin with some room to spare, so that the next steps find what they ask for.
  const Real wide = margin + state.settings.contactMargin / 2;
  if (kept.known && !pair.leftOut) {
    // Of a half-space no point is near; but it is A, or does not move.
    const Real reach = bodyB.reach + state.shapes[at(pair.shapeB)].pose.p_WB.norm();
    const Real way = wayAgainst(kept, A, B, reach);
    if (margin <= kept.margin && way <= kKeptWay * state.settings.contactMargin) {
      carryManifold(kept, A, B, pair.manifold);
      pair.carried = true;
      return;
    }
    if (keepFeatures(state, pair, kept, {A, B, wide, way})) {
      pair.narrow = margin < most;
      return;
    }
  }
  collidePair(state, pair, A, B, wide);
  pair.narrow = margin < most;
  kept = keptManifold(pair.manifold, A, B, wide);
  kept.deepest = deepestOf(pair.manifold);
}

}  // namespace

void makeManifold(WorldState& state, Index index, Real time, Real rest) {
  PairSlot& pair = state.pairs[at(index)];
  if (pair.madeAt == time) return;
  const ShapeSlot &a = state.shapes[at(pair.shapeA)], &b = state.shapes[at(pair.shapeB)];
  const auto poseNow = [&](Index number, const ShapeSlot& shape) {
    const BodySlot& body = state.bodies[at(number)];
    if (body.clock == time || body.kind == BodyKind::immovable || body.asleep) {
      return poseOfShape(body, shape);
    }
    return poseOfShape(body, bodyAt(state, number, time), shape);
  };
  const Pose A = poseNow(pair.bodyA, a), B = poseNow(pair.bodyB, b);
  const Real margin = marginOf(state, pair, waysOf(state, state.bodies[at(pair.bodyA)], rest),
                               waysOf(state, state.bodies[at(pair.bodyB)], rest));
  collidePair(state, pair, A, B, margin);
  state.kept[at(index)].known = false;
  pair.madeAt = time;
  countManifold(state, pair, state.counters);
}

void remakeManifold(WorldState& state, Index index, Real time, Real rest) {
  state.pairs[at(index)].madeAt = -1;
  makeManifold(state, index, time, rest);
}

Real touchGap(const WorldState& state, const PairSlot& pair) {
  // A few roundings of the largest coordinate that enters a separation.
  constexpr Real kRoundings = 8 * std::numeric_limits<Real>::epsilon();
  const Real far = state.bodies[at(pair.bodyB)].position.cwiseAbs().maxCoeff();
  return state.settings.touchTolerance + kRoundings * far;
}

bool isClosed(const WorldState& state, const PairSlot& pair, int point) {
  const Real separation = pair.manifold.points[at(point)].separation;
  if (separation <= 0) return true;
  if (pair.force[at(point)] > 0 && separation <= state.settings.restTolerance) return true;
  return separation <= touchGap(state, pair);
}

namespace {

// What threads have seen of a pair that is awake.
enum PairLook : std::uint8_t {
  askAgain,  // by one thread, in its turn: it may join, release or wake, or is kept
  passing,   // the same, but only to ask whether it has come to a pile since
  apart,     // and has been
  near       // and has been
};

void setApart(PairSlot& pair) {
  pair.manifold.count = 0;
  pair.force = {};
  pair.madeAt = 0;
}

// Looks at a pair, and does what concerns the pair alone. What others do in their turns changes
// nothing about what is said here: bodies that are awake keep their boxes, and piles their bodies.
PairLook lookAt(const WorldState& state, PairSlot& pair, Real dt) {
  pair.madeAt = -1;
  const BodySlot &a = state.bodies[at(pair.bodyA)], &b = state.bodies[at(pair.bodyB)];
  if (a.asleep || b.asleep || isKept(state, pair)) return askAgain;
  const bool isIn = pair.island != kNone;
  if (!meets(state.shapes[at(pair.shapeA)].swept, state.shapes[at(pair.shapeB)].swept)) {
    if (isIn) return askAgain;
    pair.known = true;
    setApart(pair);
    return apart;
  }
  if (!mayTouch(state, pair, dt)) return isIn ? askAgain : passing;
  if (!isIn) return askAgain;
  pair.known = true;
  return near;
}

// A pair in its turn. Returns whether it wants a manifold.
bool takeTurn(WorldState& state, Index index, PairLook look, Real dt) {
  PairSlot& pair = state.pairs[at(index)];
  if (look == askAgain && isKept(state, pair)) {
    ++state.counters.pairsKept;
    return false;
  }
  pair.known = true;
  const bool touches = look == passing ? isOfPile(state, state.bodies[at(pair.bodyA)]) ||
                                             isOfPile(state, state.bodies[at(pair.bodyB)])
                                       : mayTouch(state, pair, dt);
  if (!touches) {
    setApart(pair);
    if (pair.island != kNone) releasePair(state, index);
    return false;
  }
  for (const Index body : {pair.bodyA, pair.bodyB}) {
    if (!state.bodies[at(body)].asleep) continue;
    wakeBody(state, body);
    moveBoxes(state, body, dt);
  }
  if (pair.island == kNone) joinByPair(state, index);
  return true;
}

// Lists the pairs that want a manifold.
void listPairsToMake(WorldState& state, Real dt) {
  Workspace& work = state.work;
  const std::size_t known = state.awakePairs.size();
  work.seen.resize(known);
  shareOut(state, known, kFewPairs, [&](std::size_t i) {
    fetchAhead(state, state.awakePairs, i);
    work.seen[i] = lookAt(state, state.pairs[at(state.awakePairs[i])], dt);
  });
  work.toMake.clear();
  // Waking adds to the list while it is walked through: what was added is looked at, too.
  for (std::size_t i = 0; i < state.awakePairs.size(); ++i) {
    const Index index = state.awakePairs[i];
    if (i >= known) state.pairs[at(index)].madeAt = -1;
    const auto look = i < known ? static_cast<PairLook>(work.seen[i]) : askAgain;
    if (look == near || (look != apart && takeTurn(state, index, look, dt))) {
      work.toMake.push_back(index);
    }
  }
  const auto all = static_cast<std::int64_t>(state.awakePairs.size());
  state.counters.pairsAwake += all;
  // The broad phase has nothing to compare if everything is near everything.
  if (state.settings.pairFinding == PairFinding::allPairs) state.counters.pairsTested += all;
}

}  // namespace

void updateManifolds(WorldState& state, Real dt) {
  listPairsToMake(state, dt);
  leaveQuietPairs(state, dt);
  // Each manifold concerns its pair alone, so that it does not matter who makes it. Some take a
  // hundred times as long as others.
  constexpr std::size_t kPiece = 32;
  const std::span<const Index> toMake = state.work.toMake;
  threadsOf(state.pile, state.settings.threads)
      .pieces(toMake.size(), kPiece, [&](std::size_t begin, std::size_t end) {
        Counters counters;
        for (std::size_t i = begin; i < end; ++i) {
          fetchAhead(state, toMake, i);
          startManifold(state, toMake[i]);
          countManifold(state, state.pairs[at(toMake[i])], counters);
        }
        addManifolds(counters, state.counters);
      });
}

}  // namespace carom::world
