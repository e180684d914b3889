#include "carom/world/advance_pile.hpp"

#include <algorithm>

#include "carom/core/cross.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// Fewer bodies or contacts than this are not worth a second thread.
constexpr std::size_t kFew = 64;

// What the events of a step have left is a force over whatever time was left of it: it may be
// thousands of times what a whole step needs, and threw bodies out of a heap as if shot.
void dropForcesOfEvents(PairSlot& pair) {
  if (pair.bySoftSteps || pair.leftOut) return;
  pair.force = {};
  pair.rub = Vector3::Zero();
  pair.twist = 0;
}

// Bodies get numbers, those that contacts can move first.
void numberBodies(WorldState& state, std::span<const Index> islands) {
  std::vector<Index>& members = state.pile.members;
  members.clear();
  for (const Index island : islands) {
    for (const Index body : state.islands[at(island)].bodies) {
      state.bodies[at(body)].local = static_cast<Index>(members.size());
      members.push_back(body);
    }
  }
}

// What is asked of the pairs of all islands, in their order. Pairs lie far apart in memory, so all
// threads look at them.
void lookAtPairs(WorldState& state, std::span<const Index> islands) {
  Pile& pile = state.pile;
  pile.looks.clear();
  for (const Index island : islands) {
    for (const Index pair : state.islands[at(island)].pairs) pile.looks.push_back({.pair = pair});
  }
  const auto numberOf = [&](Index index) {
    const BodySlot& body = state.bodies[at(index)];
    return isDynamic(body) ? body.local : kNone;
  };
  shareOut(state, pile.looks.size(), 2 * kFew, [&](std::size_t i) {
    PileLook& look = pile.looks[i];
    PairSlot& pair = state.pairs[at(look.pair)];
    dropForcesOfEvents(pair);
    if (pair.leftOut || pair.manifold.count == 0) return;
    look.count = static_cast<std::uint8_t>(pair.manifold.count);
    look.a = numberOf(pair.bodyA);
    look.b = numberOf(pair.bodyB);
  });
}

// Pairs with points become edges; what they touch and cannot move gets a number as well.
void numberContacts(WorldState& state) {
  Pile& pile = state.pile;
  pile.pairs.clear();
  pile.edges.clear();
  pile.counts.clear();
  const auto numberOf = [&](Index index) {
    BodySlot& body = state.bodies[at(index)];
    const bool known = body.local >= 0 && at(body.local) < pile.members.size() &&
                       pile.members[at(body.local)] == index;
    if (!known) {
      body.local = static_cast<Index>(pile.members.size());
      pile.members.push_back(index);
    }
    return body.local;
  };
  for (const PileLook& look : pile.looks) {
    if (look.count == 0) continue;
    const Index a = look.a >= 0 ? look.a : numberOf(state.pairs[at(look.pair)].bodyA);
    const Index b = look.b >= 0 ? look.b : numberOf(state.pairs[at(look.pair)].bodyB);
    pile.pairs.push_back(look.pair);
    pile.edges.push_back({a, b});
    pile.counts.push_back(look.count);
  }
}

// What a body's own turning does to its rate. In a heap that rests bodies turn so little that one
// round finds it: of what the usual two find a millionth is missing.
Vector3 turnedInPile(const BodySlot& body, Real dt) {
  constexpr Real kLittle = 1e-3;  // [rad]
  const Vector3& rate = body.velocity.angular;
  if (rate.squaredNorm() * dt * dt > kLittle * kLittle) {
    return turnedRate(body, dt) - rate;
  }
  const Matrix3& R = body.pose.R_WB;
  const Vector3 seen = R.transpose() * rate;
  const Vector3 momentum = body.moments.cwiseProduct(seen);
  return dt * (R * cross(momentum, seen).cwiseQuotient(body.moments));
}

// A body as the solver sees it, and what forces and its own turning add to its velocity.
void describeBody(WorldState& state, std::size_t i, Real dt, int shortSteps) {
  Pile& pile = state.pile;
  const BodySlot& body = state.bodies[at(pile.members[i])];
  Velocity gain;
  if (isDynamic(body)) {
    gain.linear = dt * freeAcceleration(state, body);
    if (nutates(state, body)) {
      gain.angular = turnedInPile(body, dt);
    }
    if (body.torque != Vector3::Zero()) {
      gain.angular += dt * (body.mass.inverseInertia * body.torque);
    }
  }
  // What turns far is pushed as it lies in the middle of the step.
  BodyMass mass = body.mass;
  if (needsEnergyKept(body, body.velocity.angular, dt)) {
    mass.inverseInertia = inverseInertiaOf(body, middleOf(body, dt));
  }
  pile.steps.setBody(i, {mass, body.velocity}, gain, shortSteps);
}

void describeContact(WorldState& state, std::size_t place, Real duration) {
  Pile& pile = state.pile;
  const Index contact = pile.steps.contactAt(place);
  if (contact < 0) return;
  const PairSlot& pair = state.pairs[at(pile.pairs[at(contact)])];
  const Vector3& a = state.bodies[at(pair.bodyA)].position;
  const Vector3& b = state.bodies[at(pair.bodyB)].position;
  const bool warm = state.settings.warmStarting;
  PileContact soft;
  soft.normal = pair.manifold.normal;
  soft.count = pair.manifold.count;
  for (int i = 0; i < soft.count; ++i) {
    const ManifoldPoint& from = pair.manifold.points[at(i)];
    SoftPoint& point = soft.points[at(i)];
    point.armA = from.position - a;
    point.armB = from.position - b;
    point.separation = from.separation;
    if (warm) point.force = pair.force[at(i)];
  }
  soft.friction = pair.friction;
  soft.restitution = pair.restitution;
  if (warm) {
    soft.rub = pair.rub;
    soft.twist = pair.twist;
  }
  pile.steps.setContact(place, soft, duration);
}

void storeForces(WorldState& state, std::size_t place, Real duration) {
  Pile& pile = state.pile;
  const Index contact = pile.steps.contactAt(place);
  if (contact < 0) return;
  PairSlot& pair = state.pairs[at(pile.pairs[at(contact)])];
  const SoftForces forces = pile.steps.contact(place, duration);
  pair.force = forces.normal;
  pair.rub = forces.rub;
  pair.twist = forces.twist;
  pair.sticks = forces.sticks;
  pair.bySoftSteps = true;
}

// What has to be done for a body by one thread, after all have moved those that contacts push.
enum AfterMotion : std::uint8_t { nothing, dropItsAnchor, moveFreely };

// What no contact has moved is left to the closed form.
AfterMotion takeMotion(WorldState& state, std::size_t i, Real dt, Real until) {
  const SoftMotion motion = state.pile.steps.body(i);
  BodySlot& body = state.bodies[at(state.pile.members[i])];
  body.byEnd = false;
  body.isFree = !motion.touched;
  if (body.isFree) {
    body.acceleration = freeAcceleration(state, body);
    body.turning = Vector3::Zero();
    return moveFreely;
  }
  const bool isFast = needsEnergyKept(body, body.velocity.angular, dt);
  const Matrix3 middle = isFast ? middleOf(body, dt) : Matrix3::Identity();
  body.position += motion.way;
  if (motion.turn != Vector3::Zero()) {
    body.orientation = integrateOrientation(body.orientation, motion.turn, 1);
  }
  body.velocity = motion.velocity;
  body.acceleration = body.turning = Vector3::Zero();
  body.clock = until;
  refreshPose(body);
  if (isFast) keepTurningEnergy(body, middle);
  return body.anchor ? dropItsAnchor : nothing;
}

// Bodies share the list of anchors, and drop theirs before others take new ones.
void takeMotions(WorldState& state, std::size_t movable, Real dt, Real until) {
  std::vector<std::uint8_t>& after = state.work.seen;
  after.resize(movable);
  shareOut(state, movable, kFew,
           [&](std::size_t i) { after[i] = takeMotion(state, i, dt, until); });
  for (std::size_t i = 0; i < movable; ++i) {
    if (after[i] == dropItsAnchor) dropAnchor(state, state.bodies[at(state.pile.members[i])]);
  }
  for (std::size_t i = 0; i < movable; ++i) {
    if (after[i] == moveFreely) moveBody(state, state.pile.members[i], until, true);
  }
}

}  // namespace

void advancePiles(WorldState& state, std::span<const Index> islands, Real start, Real until) {
  if (islands.empty()) return;
  const Real dt = until - start;
  Pile& pile = state.pile;
  numberBodies(state, islands);
  const std::size_t movable = pile.members.size();
  lookAtPairs(state, islands);
  numberContacts(state);
  // As much as the swings of tall walls ask for; less leaves them, more lets the walls sink.
  constexpr Real kGive = 0.28;
  const SoftSettings settings{.shortSteps = state.settings.shortSteps,
                              .give = kGive,
                              .slowestBounce = state.settings.gravity.norm() * dt,
                              .width = state.settings.rowWidth};
  const Real duration = dt / settings.shortSteps;
  pile.steps.begin(pile.members.size(), movable, RowNumbers::floats);
  shareOut(state, pile.members.size(), kFew,
           [&](std::size_t i) { describeBody(state, i, dt, settings.shortSteps); });
  pile.steps.place(pile.edges, pile.counts);
  shareOut(state, pile.steps.places(), kFew,
           [&](std::size_t i) { describeContact(state, i, duration); });
  const SoftCounts counts = pile.steps.run(settings, dt, threadsOf(pile, state.settings.threads));
  state.counters.pileBodies += static_cast<std::int64_t>(movable);
  state.counters.pileContacts += static_cast<std::int64_t>(pile.pairs.size());
  state.counters.pileColors = std::max<std::int64_t>(state.counters.pileColors, counts.colors);
  state.counters.rowsSolved += counts.rows;
  shareOut(state, pile.steps.places(), kFew,
           [&](std::size_t i) { storeForces(state, i, duration); });
  takeMotions(state, movable, dt, until);
}

}  // namespace carom::world
