#include "carom/world/quiet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/core/reserve_ahead.hpp"
#include "carom/world/move_body.hpp"

namespace carom::world {

namespace {

constexpr std::size_t kFew = 128;  // bodies or pairs are not worth a second thread

void describe(const WorldState& state, const BodySlot& body, Real dt, QuietBody& quiet) {
  quiet = QuietBody();
  quiet.isDynamic = isDynamic(body);
  if (body.kind == BodyKind::immovable || body.asleep) return;
  quiet.ahead = dt * body.velocity.linear;
  quiet.bent = dt * dt / 2 * freeAcceleration(state, body);
  const auto isBall = [&](Index shape) { return isCentredBall(state.shapes[at(shape)]); };
  const bool anyBall = std::any_of(body.shapes.begin(), body.shapes.end(), isBall);
  // A ball that turns about its middle goes nowhere, and its box has no room for that.
  if (!anyBall || body.shapes.size() > 1) quiet.round = body.round;
  quiet.way = body.straight + quiet.round;
  quiet.room = std::max(anyBall ? body.straight : quiet.way, body.struck);
  // Of what is not looked at in this step nothing is known.
  if (body.kept || body.struck > 0) quiet.until = 0;
}

// By how much two quiet bodies can come nearer.
Real wayOfQuiet(const QuietBody& a, const QuietBody& b) {
  return (b.ahead - a.ahead).norm() + (b.bent - a.bent).norm() + a.round + b.round;
}

// How near two bodies can come, the first of which to be touched is quiet until then.
Real wayOf(const QuietBody& a, const QuietBody& b) {
  const Real all = a.way + b.way;
  return std::min(all, wayOfQuiet(a, b) + (1 - std::min(a.until, b.until)) * all);
}

// A gap that is surely there: that of their boxes.
Real gapOf(const ShapeSlot& a, const QuietBody& ofA, const ShapeSlot& b, const QuietBody& ofB) {
  const Vector3 gaps = (a.swept.low - b.swept.high).cwiseMax(b.swept.low - a.swept.high);
  return gaps.maxCoeff() + ofA.room + ofB.room;
}

// What is not quiet spreads from pair to pair until nothing changes, or for too long: then nobody is
// quiet.
void spread(Workspace& work) {
  constexpr int kMost = 64;
  bool isSpreading = true;
  for (int round = 0; round < kMost && isSpreading; ++round) {
    isSpreading = false;
    for (const QuietPair& pair : work.quietPairs) {
      QuietBody &a = work.quiet[at(pair.bodyA)], &b = work.quiet[at(pair.bodyB)];
      QuietBody& later = a.until < b.until ? b : a;
      const Real met = std::min(a.until, b.until) + pair.part;
      if (!later.isDynamic || met >= later.until) continue;
      later.until = met;
      isSpreading = true;
    }
  }
  if (!isSpreading) return;
  for (const QuietPair& pair : work.quietPairs) {
    work.quiet[at(pair.bodyA)].until = work.quiet[at(pair.bodyB)].until = 0;
  }
}

// A pair as described bodies make it. Nothing is changed: several threads do this at the same time.
QuietPair quietPair(const WorldState& state, Index index) {
  const PairSlot& pair = state.pairs[at(index)];
  // What cannot be moved is A, and in no list of bodies.
  const bool byWall = state.bodies[at(pair.bodyA)].kind == BodyKind::immovable;
  const QuietBody wall;
  const QuietBody &a = byWall ? wall : state.work.quiet[at(pair.bodyA)],
                  &b = state.work.quiet[at(pair.bodyB)];
  const Real gap = gapOf(state.shapes[at(pair.shapeA)], a, state.shapes[at(pair.shapeB)], b) -
                   state.settings.contactMargin;
  const Real room = gap - wayOfQuiet(a, b), all = a.way + b.way;
  const bool atOnce = !(room > 0);
  // A part of more than a whole step is never handed on.
  const Real part = atOnce ? 0 : room < all ? room / all : Real(1);
  return {index, pair.bodyA, pair.bodyB, gap, part, byWall};
}

// What may touch at once is not quiet.
void endQuiet(Workspace& work, const QuietPair& pair) {
  QuietBody &a = work.quiet[at(pair.bodyA)], &b = work.quiet[at(pair.bodyB)];
  if (pair.byWall) a = QuietBody();
  if (pair.part != 0) return;
  if (a.isDynamic) a.until = 0;
  if (b.isDynamic) b.until = 0;
}

bool canTouch(const WorldState& state, const QuietPair& pair) {
  const QuietBody &a = state.work.quiet[at(pair.bodyA)], &b = state.work.quiet[at(pair.bodyB)];
  if (pair.part == 0 || !a.isDynamic || !b.isDynamic) return true;
  return pair.gap <= wayOf(a, b) || !isOfPile(state, state.pairs[at(pair.pair)]);
}

void leaveOut(PairSlot& pair) {
  pair.madeAt = 0;
  if (pair.leftOut) return;
  pair.manifold.count = 0;
  pair.force = {};
  pair.carried = false;
  pair.narrow = pair.leftOut = true;
}

}  // namespace

void leaveQuietPairs(WorldState& state, Real dt) {
  Workspace& work = state.work;
  work.knowsQuiet = false;
  const auto ofPile = [&](Index index) { return isOfPile(state, state.pairs[at(index)]); };
  if (state.longSteps || std::none_of(work.toMake.begin(), work.toMake.end(), ofPile)) return;
  // Where nobody goes farther than surfaces are watched there is nothing to gain.
  const auto goesFar = [&](Index index) {
    const BodySlot& body = state.bodies[at(index)];
    return body.straight + body.round > state.settings.contactMargin;
  };
  if (std::none_of(state.awakeBodies.begin(), state.awakeBodies.end(), goesFar)) return;
  work.knowsQuiet = true;
  work.quiet.resize(state.bodies.size());
  shareOut(state, state.awakeBodies.size(), kFew, [&](std::size_t i) {
    const Index index = state.awakeBodies[i];
    describe(state, state.bodies[at(index)], dt, work.quiet[at(index)]);
  });
  const std::size_t count = work.toMake.size();
  reserveAhead(work.quietPairs, count);
  work.quietPairs.resize(count);
  shareOut(state, count, kFew, [&](std::size_t i) {
    fetchAhead(state, work.toMake, i);
    work.quietPairs[i] = quietPair(state, work.toMake[i]);
  });
  for (const QuietPair& pair : work.quietPairs) endQuiet(work, pair);
  spread(work);
  work.seen.resize(count);
  shareOut(state, count, kFew, [&](std::size_t i) {
    const QuietPair& pair = work.quietPairs[i];
    work.seen[i] = canTouch(state, pair) ? 1 : 0;
    if (work.seen[i] == 0) leaveOut(state.pairs[at(pair.pair)]);
  });
  work.toMake.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (work.seen[i] != 0) work.toMake.push_back(work.quietPairs[i].pair);
  }
}

Real quietReach(const WorldState& state, const PairSlot& pair) {
  if (!state.work.knowsQuiet) return std::numeric_limits<Real>::infinity();
  const QuietBody &a = state.work.quiet[at(pair.bodyA)], &b = state.work.quiet[at(pair.bodyB)];
  return a.isDynamic && b.isDynamic ? wayOf(a, b) : std::numeric_limits<Real>::infinity();
}

}  // namespace carom::world
