#include "carom/world/quiet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/world/move_body.hpp"

namespace carom::world {

namespace {

void describe(const WorldState& state, const BodySlot& body, Real dt, QuietBody& quiet) {
  quiet = QuietBody();
  const bool moves = body.alive && body.kind != BodyKind::immovable && !body.asleep;
  if (!moves) return;
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

bool isOfPile(const WorldState& state, const PairSlot& pair) {
  return pair.island != kNone && state.islands[at(pair.island)].isPile;
}

// What is not quiet spreads through the links until nothing changes, or for too long: then nobody
// is quiet.
void spread(Workspace& work) {
  constexpr int kMost = 64;
  bool changed = true;
  for (int round = 0; round < kMost && changed; ++round) {
    changed = false;
    for (const QuietLink& link : work.quietLinks) {
      Real &a = work.quiet[at(link.a)].until, &b = work.quiet[at(link.b)].until;
      const Real met = std::min(a, b) + link.part;
      if (met >= std::max(a, b)) continue;
      (a < b ? b : a) = met;
      changed = true;
    }
  }
  if (!changed) return;
  for (QuietBody& body : work.quiet) body.until = 0;
}

}  // namespace

void leaveQuietPairs(WorldState& state, Real dt) {
  Workspace& work = state.work;
  work.quiet.clear();
  work.quietLinks.clear();
  const auto ofPile = [&](Index index) { return isOfPile(state, state.pairs[at(index)]); };
  if (state.longSteps || std::none_of(work.toMake.begin(), work.toMake.end(), ofPile)) return;
  work.quiet.resize(state.bodies.size());
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    describe(state, state.bodies[i], dt, work.quiet[i]);
  }
  // Who may touch at once, and who if one of them is touched.
  for (const Index index : work.toMake) {
    const PairSlot& pair = state.pairs[at(index)];
    QuietBody &a = work.quiet[at(pair.bodyA)], &b = work.quiet[at(pair.bodyB)];
    const Real gap = gapOf(state.shapes[at(pair.shapeA)], a, state.shapes[at(pair.shapeB)], b);
    const bool movesA = isDynamic(state.bodies[at(pair.bodyA)]),
               movesB = isDynamic(state.bodies[at(pair.bodyB)]);
    const Real room = gap - state.settings.contactMargin - wayOfQuiet(a, b);
    if (!(room > 0)) {
      if (movesA) a.until = 0;
      if (movesB) b.until = 0;
    } else if (movesA && movesB && room < a.way + b.way) {
      work.quietLinks.push_back({pair.bodyA, pair.bodyB, room / (a.way + b.way)});
    }
  }
  spread(work);
  std::erase_if(work.toMake, [&](Index index) {
    PairSlot& pair = state.pairs[at(index)];
    if (!isOfPile(state, pair) || !isDynamic(state.bodies[at(pair.bodyA)])) return false;
    const QuietBody &a = work.quiet[at(pair.bodyA)], &b = work.quiet[at(pair.bodyB)];
    const Real gap = gapOf(state.shapes[at(pair.shapeA)], a, state.shapes[at(pair.shapeB)], b);
    if (gap <= state.settings.contactMargin + wayOf(a, b)) return false;
    pair.manifold.count = 0;
    pair.force = {};
    pair.madeAt = 0;
    pair.carried = false;
    pair.narrow = true;
    state.kept[at(index)].known = false;
    return true;
  });
}

Real quietReach(const WorldState& state, const PairSlot& pair) {
  const std::vector<QuietBody>& quiet = state.work.quiet;
  if (quiet.empty() || !isDynamic(state.bodies[at(pair.bodyA)])) {
    return std::numeric_limits<Real>::infinity();
  }
  return wayOf(quiet[at(pair.bodyA)], quiet[at(pair.bodyB)]);
}

}  // namespace carom::world
