#include "carom/world/keep_energy.hpp"

#include <algorithm>
#include <cmath>

#include "carom/solver/soft_steps.hpp"
#include "carom/world/move_body.hpp"

namespace carom::world {

namespace {

// Who moves with all that holds an island sees no work done by it. Without anything that holds it
// that is who falls with the middle of its bodies.
bool findFrame(const WorldState& state, IslandSlot& island) {
  bool known = false;
  island.frame = island.frameFalls = Vector3::Zero();
  for (const Index index : island.pairs) {
    const BodySlot& wall = state.bodies[at(state.pairs[at(index)].bodyA)];
    if (isDynamic(wall)) continue;
    if (wall.velocity.angular != Vector3::Zero()) return false;
    if (known && wall.velocity.linear != island.frame) return false;
    island.frame = wall.velocity.linear;
    known = true;
  }
  if (known) return true;
  Real mass = 0;
  for (const Index index : island.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    mass += body.weight;
    island.frame += body.weight * body.velocity.linear;
    island.frameFalls += body.weight * freeAcceleration(state, body);
  }
  island.frame /= mass;
  island.frameFalls /= mass;
  return true;
}

// As somebody sees it who moves at this velocity [J].
Real motionOf(const WorldState& state, const IslandSlot& island, const Vector3& frame) {
  Real sum = 0;
  for (const Index index : island.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    sum += body.weight * (body.velocity.linear - frame).squaredNorm() +
           turningEnergy(body, body.pose.R_WB, body.velocity.angular);
  }
  return sum / 2;
}

// What a body needs to be moved against what acts on it, as that is seen [J].
Real costOf(const WorldState& state, const IslandSlot& island, const BodySlot& body,
            const Vector3& way) {
  return -body.weight * (freeAcceleration(state, body) - island.frameFalls).dot(way);
}

// What a body is lifted by for nothing [J].
Real costOfHeight(const WorldState& state, const BodySlot& body, Real height) {
  return body.weight * freeAcceleration(state, body).norm() * height;
}

// Soft steps lift what lies in something else by ways that are no motion. How far a body may have
// come by that: as fast as they pull, and by what overlaps there were [m].
Real pulledHeight(const WorldState& state, const IslandSlot& island, Real duration) {
  const Real most = SoftSettings().slowestPull * duration;
  Real overlaps = 0;
  for (const Index index : island.pairs) {
    const PairSlot& pair = state.pairs[at(index)];
    if (pair.leftOut) continue;
    Real deepest = 0;
    for (int i = 0; i < pair.manifold.count; ++i) {
      deepest = std::max(deepest, -pair.manifold.points[at(i)].separation);
    }
    overlaps += deepest;
    if (overlaps >= most) return most;
  }
  return overlaps;
}

}  // namespace

void watchEnergy(WorldState& state, IslandSlot& island) {
  const bool turns = std::any_of(island.bodies.begin(), island.bodies.end(), [&](Index index) {
    return state.bodies[at(index)].torque != Vector3::Zero();
  });
  island.energyKept =
      !turns && !state.longSteps && state.settings.gyroscopic && findFrame(state, island);
  if (!island.energyKept) return;
  island.motion = motionOf(state, island, island.frame);
  // Of the size of a body, by which it is lifted in a step though nothing pays for it. Who looks at
  // the ends of steps only has bodies deep in each other all the time, and lifts them all.
  constexpr Real kLent = 1.0 / 200;
  island.lent = state.settings.continuous ? 0 : kNever;
  island.lifted = 0;
  for (const Index index : island.bodies) {
    const BodySlot& body = state.bodies[at(index)];
    island.lent += costOfHeight(state, body, kLent * body.reach);
  }
  island.mayLift = island.motion + island.lent;
}

Real paidShare(WorldState& state, std::span<const Index> bodies) {
  IslandSlot& island = state.islands[at(state.bodies[at(bodies.front())].island)];
  if (!island.energyKept) return 1;
  Real cost = 0;
  for (const Index index : bodies) {
    const BodySlot& body = state.bodies[at(index)];
    cost += costOf(state, island, body, state.work.moving[at(body.local)].velocity.linear);
  }
  const Real share = cost > island.mayLift ? island.mayLift / cost : 1;
  island.mayLift -= share * cost;
  return share;
}

void payForWay(const WorldState& state, IslandSlot& island, BodySlot& body, const Vector3& way) {
  const Real length = way.norm();
  if (!island.energyKept || length <= state.settings.restTolerance) return;
  const Vector3 along = way / length;
  const Real cost = costOf(state, island, body, way);
  if (!(cost > 0)) return;
  const Real speed = along.dot(body.velocity.linear - island.frame);
  const Real left = std::max(Real(0), speed * speed - 2 * body.mass.inverseMass * cost);
  body.velocity.linear += (std::copysign(std::sqrt(left), speed) - speed) * along;
  island.lifted += cost - body.weight * (speed * speed - left) / 2;
}

Real keptShare(const WorldState& state, const IslandSlot& island, std::span<const Pose> starts,
               Real duration) {
  if (!island.energyKept) return kAllSpeed;
  const Vector3 frame = island.frame + duration * island.frameFalls;
  const Vector3 ahead = duration / 2 * (island.frame + frame);
  const auto costOfBody = [&](std::size_t i) {
    const BodySlot& body = state.bodies[at(island.bodies[i])];
    return costOf(state, island, body, body.position - starts[i].p_WB - ahead);
  };
  Real most = island.motion + std::min(island.lifted, island.lent), mass = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    most -= costOfBody(i);
    mass += state.bodies[at(island.bodies[i])].weight;
  }
  // Of the motion there was and of what gravity gives in a step. Soft steps are of the first order.
  const Real visible = island.isPile ? 0 : 1e-6;
  const Real slack = island.motion + mass * (duration * state.settings.gravity).squaredNorm();
  const Real now = motionOf(state, island, frame);
  if (!(now > 0) || now <= most + visible * slack) return kAllSpeed;
  const Real pulled = island.isPile ? pulledHeight(state, island, duration) : 0;
  for (std::size_t i = 0; pulled > 0 && i < island.bodies.size(); ++i) {
    const BodySlot& body = state.bodies[at(island.bodies[i])];
    most += std::clamp(costOfBody(i), Real(0), costOfHeight(state, body, pulled));
  }
  return now > most ? std::sqrt(std::max(Real(0), most) / now) : kAllSpeed;
}

void slowDown(WorldState& state, const IslandSlot& island, Real share, Real duration) {
  const Vector3 frame = island.frame + duration * island.frameFalls;
  ++state.counters.energiesKept;
  for (const Index index : island.bodies) {
    BodySlot& body = state.bodies[at(index)];
    dropAnchor(state, body);
    body.velocity.linear = frame + share * (body.velocity.linear - frame);
    body.velocity.angular *= share;
  }
}

void keepEnergy(WorldState& state, const IslandSlot& island, std::span<const Pose> starts,
                Real duration) {
  const Real share = keptShare(state, island, starts, duration);
  if (share != kAllSpeed) slowDown(state, island, share, duration);
}

}  // namespace carom::world
