#include "carom/world/resolve_impacts.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/reserve_ahead.hpp"
#include "carom/impulse/bounded_impact.hpp"
#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/simultaneous_impacts.hpp"
#include "carom/world/contact_phase.hpp"
#include "carom/world/move_body.hpp"
#include "carom/world/update_contacts.hpp"

namespace carom::world {

namespace {

// What is known of a set before anything is done.
struct Approach {
  Real fastest = 0;      // approach of a closed point [m/s]
  Real restitution = 0;  // the largest of those that bounce
};

Approach approachOf(const WorldState& state, std::span<const Index> pairs, bool bounce) {
  const Real slow = slowSpeed(state);
  Approach seen;
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    for (int i = 0; i < pair.manifold.count; ++i) {
      if (!isClosed(state, pair, i)) continue;
      const Real speed = -partingSpeed(state, pair, i);
      if (speed <= slow) continue;
      seen.fastest = std::max(seen.fastest, speed);
      if (bounce && pair.restitution * speed > state.slowestBounce) {
        seen.restitution = std::max(seen.restitution, pair.restitution);
      }
    }
  }
  return seen;
}

void report(WorldState& state, Index index, int point, Real time, Real approach, Real impulse) {
  const PairSlot& pair = state.pairs[at(index)];
  const ContactEvent ids = eventOf(state, pair);
  reserveAhead(state.impacts, std::max(state.impacts.size() + 1, 2 * state.bodies.size()));
  state.impacts.push_back({ids.shapeA, ids.shapeB, ids.bodyA, ids.bodyB, state.partStart + time,
                           pair.manifold.points[at(point)].position, pair.manifold.normal, approach,
                           impulse, 0});
}

// The closed points as contacts of chapter 5.
void listContacts(WorldState& state, std::span<const Index> pairs) {
  Workspace& work = state.work;
  work.contacts.clear();
  work.contactPairs.clear();
  work.contactPoints.clear();
  const Real slow = slowSpeed(state);
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    for (int i = 0; i < pair.manifold.count; ++i) {
      if (!isClosed(state, pair, i)) continue;
      const PatchPoint arms = armsOf(state, pair, i);
      const bool bounces =
          pair.restitution * std::abs(partingSpeed(state, pair, i)) > state.slowestBounce;
      BodyContact contact;
      contact.bodyA = state.bodies[at(pair.bodyA)].local;
      contact.bodyB = state.bodies[at(pair.bodyB)].local;
      contact.contact = {pair.manifold.normal, arms.armA, arms.armB};
      contact.law = {bounces || -partingSpeed(state, pair, i) <= slow ? pair.restitution : 0,
                     pair.friction, 0};
      work.contacts.push_back(contact);
      work.contactPairs.push_back(index);
      work.contactPoints.push_back(i);
    }
  }
}

// Newton's balls and their like: rounds, or one law for one point.
void bounceAll(WorldState& state, std::span<const Index> pairs, Real time) {
  Workspace& work = state.work;
  listContacts(state, pairs);
  const auto reportAt = [&](std::size_t i, Real approach, Real impulse) {
    report(state, work.contactPairs[i], work.contactPoints[i], time, approach, impulse);
  };
  if (work.contacts.size() == 1) {
    const BodyContact& one = work.contacts[0];
    MovingBody &a = work.moving[at(one.bodyA)], &b = work.moving[at(one.bodyB)];
    const Real approach = -relativeVelocity(a, b, one.contact).dot(one.contact.normal);
    const Vector3 impulse = boundedImpact(a, b, one.contact, one.law).impulse;
    changeVelocities(a, b, one.contact, impulse);
    reportAt(0, approach, impulse.dot(one.contact.normal));
    return;
  }
  std::vector<Real>& approach = work.approaches;
  approach.resize(work.contacts.size());
  for (std::size_t i = 0; i < work.contacts.size(); ++i) {
    const BodyContact& c = work.contacts[i];
    approach[i] = -relativeVelocity(work.moving[at(c.bodyA)], work.moving[at(c.bodyB)], c.contact)
                       .dot(c.contact.normal);
  }
  SimultaneousImpacts& done = work.impactRounds;
  simultaneousImpacts(work.moving, work.contacts, {.stopsSlip = true}, work.impactMemory, done);
  for (std::size_t i = 0; i < work.contacts.size(); ++i) {
    if (done.normalImpulses[i] > 0) reportAt(i, approach[i], done.normalImpulses[i]);
  }
}

// Solves the patches as they are, for no time at all. However slowly bodies meet, of what they move
// with there are roundings in the speeds at which they do.
void solveNow(WorldState& state, Real approach) {
  Workspace& work = state.work;
  work.blocks.clear();
  for (const WorkPatch& one : work.patches) {
    work.blocks.push_back(prepareBlock(one.patch, work.moving));
  }
  solveBlocks(state, fastestOf(work, approach), true);
}

// Whether pressure cannot turn a body: it is a ball about its middle.
bool isOneBall(const WorldState& state, const BodySlot& body) {
  if (body.shapes.size() != 1) return false;
  return isCentredBall(state.shapes[at(body.shapes[0])]);
}

// What rounding makes of arms and normals is no spin: a ball that nothing rubs does not turn.
void takeVelocities(WorldState& state, std::span<const Index> bodies,
                    std::span<const Index> pairs) {
  std::vector<std::uint8_t>& isRubbed = state.work.flags;
  isRubbed.assign(state.work.members.size(), 0);
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    if (!(pair.friction > 0)) continue;
    for (const Index body : {pair.bodyA, pair.bodyB}) {
      isRubbed[at(state.bodies[at(body)].local)] = 1;
    }
  }
  for (const Index index : bodies) {
    BodySlot& body = state.bodies[at(index)];
    Velocity after = state.work.moving[at(body.local)].velocity;
    if (isRubbed[at(body.local)] == 0 && isOneBall(state, body)) {
      after.angular = body.velocity.angular;
    }
    if (after.angular != body.velocity.angular) dropAnchor(state, body);
    body.velocity = after;
  }
}

// Tells of what has just been solved; speeds are still those of before.
void reportSolved(WorldState& state, Real time) {
  const Workspace& work = state.work;
  for (std::size_t i = 0; i < work.blocks.size(); ++i) {
    const ContactBlock& block = work.blocks[i];
    const PairSlot& pair = state.pairs[at(work.patches[i].pair)];
    for (int k = 0; k < block.count; ++k) {
      const int point = work.patches[i].pointOf[at(k)];
      const Real approach = -partingSpeed(state, pair, point);
      if (block.impulses[at(k)] > 0 && approach > slowSpeed(state)) {
        report(state, work.patches[i].pair, point, time, approach, block.impulses[at(k)]);
      }
    }
  }
}

// A patch of a pair for an impact, without points yet.
WorkPatch impactPatch(const WorldState& state, Index index) {
  WorkPatch one = patchOf(state, index);
  // Friction in an impact is what it takes to stick, within the cone, however fast the slip is.
  one.patch.slowest = std::numeric_limits<Real>::infinity();
  return one;
}

// Twice the energy of motion of the bodies at hand, before or after what has been solved, as those
// see it that nothing stops, for whom they do no work; infinite before, if these move against each
// other or turn, and so may have given some.
Real motionOf(const WorldState& state, bool after) {
  const Workspace& work = state.work;
  Vector3 frame = Vector3::Zero();
  bool known = false;
  for (const Index index : work.members) {
    const BodySlot& body = state.bodies[at(index)];
    if (isDynamic(body)) continue;
    const bool differs = known && body.velocity.linear != frame;
    if (!after && (differs || body.velocity.angular != Vector3::Zero())) {
      return std::numeric_limits<Real>::infinity();
    }
    frame = body.velocity.linear;
    known = true;
  }
  Real sum = 0;
  for (std::size_t i = 0; i < work.members.size(); ++i) {
    const BodySlot& body = state.bodies[at(work.members[i])];
    const Velocity& v = after ? work.moving[i].velocity : body.velocity;
    if (!isDynamic(body)) continue;
    sum += body.weight * (v.linear - frame).squaredNorm() +
           turningEnergy(body, body.pose.R_WB, v.angular);
  }
  return sum;
}

// Bounces that are asked for in several places at once may ask for more than there is. Then they
// are as much less as keeps the energy: between no bounce, which loses some, and that.
void bounceLess(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                Real fastest, Real most) {
  Workspace& work = state.work;
  work.bounced.clear();
  for (const MovingBody& body : work.moving) work.bounced.push_back(body.velocity);
  gather(state, bodies, pairs);
  for (WorkPatch& one : work.patches) {
    for (int k = 0; k < one.patch.count; ++k) {
      Real& target = one.patch.points[at(k)].target;
      target = std::min(target, Real(0));
    }
  }
  solveNow(state, fastest);
  // The energy is a parabola over the share of the bounce, and starts below.
  Real low = 0, high = 1;
  constexpr int kHalvings = 30;
  work.stopped.clear();
  for (const MovingBody& body : work.moving) work.stopped.push_back(body.velocity);
  const auto take = [&](Real share) {
    for (std::size_t i = 0; i < work.moving.size(); ++i) {
      const Velocity &a = work.stopped[i], &b = work.bounced[i];
      work.moving[i].velocity = {a.linear + share * (b.linear - a.linear),
                                 a.angular + share * (b.angular - a.angular)};
    }
  };
  for (int i = 0; i < kHalvings; ++i) {
    const Real middle = (low + high) / 2;
    take(middle);
    (motionOf(state, true) <= most ? low : high) = middle;
  }
  take(low);
}

void stopAll(WorldState& state, std::span<const Index> pairs, Real time, Real fastest) {
  Workspace& work = state.work;
  work.patches.clear();
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    WorkPatch one = impactPatch(state, index);
    for (int i = 0; i < pair.manifold.count; ++i) {
      if (isClosed(state, pair, i)) addPoint(one, i, armsOf(state, pair, i));
    }
    if (one.patch.count > 0) work.patches.push_back(one);
  }
  solveNow(state, fastest);
  reportSolved(state, time);
}

}  // namespace

bool resolveImpacts(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                    Real time, bool bounce) {
  const Approach seen = approachOf(state, pairs, bounce);
  if (seen.fastest == 0) return false;
  ++state.counters.impacts;
  gather(state, bodies, pairs);
  if (seen.restitution > 0) {
    bounceAll(state, pairs, time);
  } else {
    stopAll(state, pairs, time, seen.fastest);
  }
  takeVelocities(state, bodies, pairs);
  return true;
}

void resolveAtOnce(WorldState& state, std::span<const Index> bodies, std::span<const Index> pairs,
                   Real time, Real dt) {
  const Real slow = slowSpeed(state);
  Real fastest = 0;
  gather(state, bodies, pairs);
  Workspace& work = state.work;
  work.patches.clear();
  for (const Index index : pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    WorkPatch one = impactPatch(state, index);
    for (int i = 0; i < pair.manifold.count; ++i) {
      const Real separation = pair.manifold.points[at(i)].separation;
      const Real speed = partingSpeed(state, pair, i);
      PatchPoint point = armsOf(state, pair, i);
      point.target = -std::max(separation, Real(0)) / dt;
      if (speed < point.target - slow) {
        fastest = std::max(fastest, -speed);
        ++state.counters.impacts;
        if (-pair.restitution * speed > state.slowestBounce)
          point.target = -pair.restitution * speed;
      }
      addPoint(one, i, point);
    }
    if (one.patch.count > 0) work.patches.push_back(one);
  }
  if (fastest == 0) return;
  solveNow(state, fastest);
  const Real before = motionOf(state, false);
  if (before < motionOf(state, true)) bounceLess(state, bodies, pairs, fastest, before);
  reportSolved(state, time);
  takeVelocities(state, bodies, pairs);
}

}  // namespace carom::world
